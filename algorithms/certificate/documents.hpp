// SPDX-License-Identifier: GPL-3.0-or-later
// Documents are the model and the pose that certificates are bound to, as plain text that anyone can read and compare.
//
// Format: JSON, its keys sorted, indented by one space, in ASCII, ended by a line feed; a number is a string as in
// certificate.hpp, an index is an integer. Its digest is the SHA-256 of all of its bytes. A model has
//   name         of the model
//   nodes        by node of the sphere tree, [first, count] of its triangles
//   triangles    [a, b, c], indices of vertices, in the order of the tree's leaves
//   vertices     a list of {joints: the numbers of those that influence it, in increasing order, position: [x, y, z], weights}
// and a pose has
//   joint_sets   all of the model's, as in a certificate
//   skinning     as in a certificate
#pragma once

#include <string>

#include "algorithms/certificate/certificate.hpp"
#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// Throws std::invalid_argument for a number that is not finite.
std::string model_document(const Character& character);
std::string pose_document(const Character& character, const SkinningPalette<double>& palette, Skinning skinning);

// Returns the vertices of a node, and the documents that they belong to (by digest).
CertifiedNode certified_node(const Character& character, int node, const std::string& about, const std::string& model_digest,
                             const std::string& pose_digest);

}  // namespace refitlab
