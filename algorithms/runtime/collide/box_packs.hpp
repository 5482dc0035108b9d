// SPDX-License-Identifier: MIT
// Boxes around many nodes at once are made from the control points of their pieces, with sixteen pieces side by side.
//
// A piece is the part of a node in one joint-set. It consists of a ball around its vertices in the reference pose, and the
// simplex {w >= low, sum w = 1} around their weights, which has as many weight vertices as joints. The image of the piece
// lies in the hull of its control points (b2_control_hull_encloses, with degree 1, 2 or 3 by the skinning), inflated by the
// ball's radius.
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
// Boxes are wider than their vertices by at least least_box. This is more than what a control point can lose by underflow:
// less than 1e5 times 2^-150. Lengths greater than largest_box are excluded, because their sums of products might overflow.
inline constexpr float least_box = 1e-37f, largest_box = 1e35f;

// This is the most that float may lose, as a share of the sizes that a box is made from. proptests/algorithms/float_budgets.cpp
// derives it from the kernel's own operations. Let u = 2^-24. All numbers are rounded to float, but the weights have no error.
// Quaternions and their blends are at most 1, up to what is accepted. Where weight vertices are near, W_kk > 1/4 and W_kl >
// sqrt(W_kk W_ll) / 2 >= 1/8, so the denominators are at least 3/8. A control point in spherical blending then loses at most 1900
// u |x| + 20 u |p| + 1700 u |r|, where r is the largest of its joints' center images. For dual quaternions, where W_kl >
// sqrt(W_kk W_ll / 2) > 1/6, it loses 990 u |p| + 820 u 2 |d|, and in linear blending 50 u of its sizes. Quaternions whose
// squared lengths are off by 1e-6 stretch the radius by 34 u each: the placement's, and the joint's in linear blending.
inline constexpr float lost_of_box = 2048 * 0x1p-24f;

// Pieces of more joints than a pack takes are bounded in double. The loss, for so many joints, is a share of all lengths in the
// computation. Quaternions whose squared lengths are off by 1e-6 stretch a ball by up to 4e-6.
constexpr double lost_of_hull(int joints) { return 1e-12 + 1e-15 * joints; }
inline constexpr double stretch_of_hull = 1 + 4.1e-6;

// These are plain arrays by lane. Lanes beyond the last piece repeat it.
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
// Returns the pieces of these nodes, with one box for each node.
inline BoxPieces make_box_pieces(const Character& character, std::span<const int> nodes) {
  return make_box_pieces(character, pieces_of_nodes(character, nodes));
}

// JointFloats has the frame's palettes of the joint-sets in float.
struct JointFloats {
  // There is a slot of eight floats for each joint of each joint-set, in that order. It has the signed quaternion, and then
  // C_j r_c (spherical), the translation (linear) or the dual part.
  std::vector<float> slots;
  std::vector<float> centers;   // r_c of each joint-set, eight floats each, of which three are used
  std::vector<int> first_slot;  // by joint-set
  float largest = 0;            // of the coordinates that the skinning looks at

  explicit JointFloats(const JointSets& sets);
  void fill(const SkinningPalette<double>& palette, Skinning skinning);
};

// Makes boxes[target] for every target. The box encloses all vertices of the node after skinning and then turning by
// rotation. The squared lengths of rotation and of the joints' quaternions must be within 1e-6 of 1. Everything is rounded
// outwards by more than float can have lost. A piece that blends rotations far apart gets a box that holds it whatever the
// rotation. If no bound is known (for dual quaternions, and for lengths beyond largest_box), it gets an infinite box.
void bound_boxes(const BoxPieces& pieces, Skinning skinning, const JointFloats& joints, const SkinningPalette<double>& palette,
                 const Quaternion<double>& rotation, std::span<FlippedBox> boxes, Target target = best_target());

}  // namespace refitlab
