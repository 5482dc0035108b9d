// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the certificate of one ball, for whoever wants to check it. The ball is that of a node of a model, in a clip at a time,
// by a refit variant.
#pragma once

#include <string>

#include "algorithms/model/load_options.hpp"
#include "algorithms/model/model.hpp"

namespace refitlab {

struct CertificateRequest {
  std::string file;                       // to be written
  int node = 0;                           // of the sphere tree; 0 is the root
  std::string clip;                       // by name; empty: the first, or the reference pose if there is none
  double seconds = 0;                     // into the clip
  std::string variant = "control_mixed";  // a sound one
};

// A model for write_certificate is loaded with these options.
inline constexpr LoadOptions certified_models{.joints = Joints::affine, .morphs = Morphs::moving};

// Writes the file, and beside it the documents of the model and of the pose (algorithms/certificate/documents.hpp), with the
// endings .model and .pose, each whole or not at all. Says on stdout what is in it, and on stderr if checkers refuse it for its
// size. Morph targets, and joints that scale in skinning in two phases, move the vertices first. The document of the model then
// has the moved vertices, in double. Throws std::invalid_argument for a node, clip, time or variant that does not exist, and
// NoProof (algorithms/certificate) for a ball that is not proved to hold its vertices.
void write_certificate(const CertificateRequest& request, Model model);

}  // namespace refitlab
