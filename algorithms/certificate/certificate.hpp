// SPDX-License-Identifier: GPL-3.0-or-later
// A certificate is a document that says why a ball holds a node's vertices. Anyone can check it.
//
// It has the node's vertices, each with its piece and how its weights are mixed of the piece's weight vertices
// (shares.hpp), the inputs of the refit (per joint-set the joints' quaternions and the center images, translations or
// dual parts; per piece the reference ball and the weight vertices), the ball, and for each piece how it is proved that
// the ball holds it (bound.hpp). Every number is an exact fraction: a program in any language can check it without a
// rounding. One is proptests/certificate/check, which shares no code with the refits; its first lines say what exactly
// is proved. Another is lemmas/proofs/checker, which is itself proved.
//
// Format: JSON, its keys sorted, indented by one space, in ASCII, ended by a line feed:
//   about        what it is of, for the reader: no part of the claim
//   ball         {center: [x, y, z], radius}; a number is a string, "-3/8" or "5", of decimal digits
//   digest       SHA-256 of the same text with "" for the digest: whatever is changed is noticed
//   joint_sets   a list of {joints: their numbers in the model, rotations: [[w, x, y, z]...], and by skinning center_images
//                and rotation_center, translations, or duals}, lists by joint; of affine joints {joints, columns: three vectors
//                a joint, offsets}
//   model, pose  SHA-256 of their documents (documents.hpp)
//   node         its number in the model's sphere tree
//   pieces       a list of {joint_set: its index, reference: its ball, weight_vertices: a list of lists of weights by
//                joint, bound}
//   skinning     "spherical", "linear", "dual_quaternion" or "affine", which is linear skinning by affine joints
//   vertices     a list of {id: in the model, piece: its index, position: [x, y, z], weights by joint, weight_vertices:
//                indices of the piece's, shares: of these weight vertices}; the weights are the weight vertices times
//                their shares, by the shares' sum
// A bound is {by: "control"}, {by: "cap", axis}, {by: "all_rotations"}, {by: "reach", axis, center} or {by: "halves", edge:
// [k, l], halves: [the bound with the middle in place of weight vertex k, that in place of l]}; of affine joints {by: "stretch",
// of_joints, of_weight_vertices}, what these make differences longer by at most.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/runtime/tree/refit_node.hpp"

namespace refitlab {

// This is thrown for a ball for which no proof was found: it misses something, or is tighter than the bounds of this library.
class NoProof : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CertifiedVertex {
  int id;  // in the model
  Point3 position;
  int joint_set;                    // in the palette
  std::span<const double> weights;  // by joint of it
};

// A certificate says this of its node beyond the data of a refit.
struct CertifiedNode {
  std::string about;  // for the reader
  int number;         // in the sphere tree
  std::vector<CertifiedVertex> vertices;
  std::vector<std::span<const int>> joints;  // by joint-set of the palette, their numbers in the model
  std::string model_digest, pose_digest;     // SHA-256
};

// Returns a certificate that the ball holds all that the skinning makes of the node's pieces, whatever refit made the ball.
// Hejl's skinning counts as spherical. Exact arithmetic takes milliseconds for each piece.
// Throws NoProof, also for a vertex that no piece holds. Throws std::invalid_argument for a number that is not finite, and for
// weights that are negative or whose sum is not exactly 1, because the proofs are not about these. It also throws
// std::invalid_argument for a palette of affine joints in other than linear skinning. Morph targets, and joints that scale in two
// phases, are certified for the vertices of a node of a deformed_character (runtime/refit/deformed_reference.hpp).
std::string certificate(const RefitNode<double>& node, Skinning skinning, const Ball3<double>& ball, const CertifiedNode& of);

}  // namespace refitlab
