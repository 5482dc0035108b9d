// SPDX-License-Identifier: MIT
// Boxes around many nodes at once, from the control points of their pieces, sixteen pieces side by side.
//
// A piece is what a node holds of one joint-set: a ball around its vertices in the reference pose, and the simplex
// {w >= low, sum w = 1} around their weights, which has as many corners as joints. The image of the piece lies in the
// hull of its control points (b2_control_hull_encloses: degree 1, 2 or 3 by the skinning) blown up by the ball's
// radius.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/runtime/collide/flipped_box.hpp"
#include "algorithms/runtime/collide/simplex_pieces.hpp"
#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

inline constexpr int box_lanes = 16;
inline constexpr int most_box_joints = 4;  // of a piece in a pack
// Boxes are wider than their vertices by this at least, which is more than what underflows of a control point: less than
// 1e5 times 2^-150. Of lengths that are greater than the other sums of products might overflow.
inline constexpr float least_box = 1e-37f, largest_box = 1e35f;

// Plain arrays by lane. Lanes beyond the last piece repeat it.
struct BoxPack {
  alignas(64) std::int32_t slot[most_box_joints][box_lanes];  // of the joint's data in the frame: JointFloats
  alignas(64) std::int32_t set[box_lanes];                    // the joint-set
  alignas(64) float low[most_box_joints][box_lanes];          // the least weights of its joints
  alignas(64) float rest[box_lanes];                          // 1 - sum low
  alignas(64) float center[3][box_lanes], radius[box_lanes];  // the reference ball, with least_box; infinite if too large
  std::int32_t target[box_lanes];                             // the box it belongs to
};

struct BoxPieces {
  std::vector<BoxPack> packs[most_box_joints];  // by number of joints - 1
  std::vector<SimplexPiece> others;             // of more joints than a pack takes: hulls of whole images, looser
};

BoxPieces make_box_pieces(const Character& character, std::span<const SimplexPiece> pieces);
// The pieces of these nodes; a box for each of them.
inline BoxPieces make_box_pieces(const Character& character, std::span<const int> nodes) {
  return make_box_pieces(character, pieces_of_nodes(character, nodes));
}

// The frame's data of the joint-sets in float.
struct JointFloats {
  // Eight floats a slot, a slot for each joint of each joint-set, in that order: the signed quaternion, then C_j r_c
  // (spherical), the translation (linear) or the dual part.
  std::vector<float> slots;
  std::vector<float> centers;   // r_c of each joint-set, eight floats each, of which three are used
  std::vector<int> first_slot;  // by joint-set
  float largest = 0;            // of the coordinates that the skinning looks at

  explicit JointFloats(const JointSets& sets);
  void fill(const SkinningPalette<double>& palette, Skinning skinning);
};

// Encloses all vertices of each node after skinning and then turning by rotation: boxes[target] for every target. The
// squared lengths of rotation and of the joints' quaternions are within 1e-6 of 1. Everything is rounded outwards by more
// than float can have lost. A piece that blends rotations far apart gets a box that holds it however it turns; where not
// even that is known (dual quaternions, lengths beyond largest_box), an infinite one.
void bound_boxes(const BoxPieces& pieces, Skinning skinning, const JointFloats& joints, const SkinningPalette<double>& palette,
                 const Quaternion<double>& rotation, std::span<FlippedBox> boxes, Target target = best_target());

}  // namespace refitlab
