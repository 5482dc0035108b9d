// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of one ball, for whoever wants to check it: a node of a model in a clip at a time, by a refit variant.
#pragma once

#include <string>

#include "algorithms/model/model.hpp"

namespace refitlab {

struct CertificateRequest {
  std::string file;                       // to be written
  int node = 0;                           // of the sphere tree; 0 is the root
  std::string clip;                       // by name; empty: the first, or the reference pose if there is none
  double seconds = 0;                     // into the clip
  std::string variant = "control_mixed";  // a sound one
};

// Returns the joints that the variant's skinning takes: affine ones in linear skinning alone.
Joints joints_of(const CertificateRequest& request);

// Writes the file, and beside it the documents of the model and of the pose (algorithms/certificate/documents.hpp), with the
// endings .model and .pose; each whole or not at all; and says what is in it. Throws std::invalid_argument for a node, clip, time or
// variant that there is not, NoProof (algorithms/certificate) for a ball that is not proved to hold its vertices.
void write_certificate(const CertificateRequest& request, Model model);

}  // namespace refitlab
