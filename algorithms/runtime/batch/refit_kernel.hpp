// SPDX-License-Identifier: MIT
// The kernels of the batch refit do Algorithm 1 repaired and the linear refit, in float and with mean balls. They take as many
// nodes at a time as there are lanes, all of them moved by the same joint-sets.
//
// Rounding. Let u = 2^-24, and n be the number of joints. In Algorithm 1 a unit quaternion q'_k / ||q'_k|| is off by (n + 7) u /
// ||q'_k||, and the apex by 6 u. So the cap's angle alpha = 4 arcsin s is off by 2 sqrt(2) (n + 19) u / ||q'_k|| (s^2 < 1/2). The
// ratios, the rotation of x = p - r_c and its length add less than 70 u ||x||. The weights are exact. The centers' images and the
// difference x are off by (n + 4) u times their sizes. All of that is less than
//     epsilon (64 + 2 n) (||x|| / min ||q'_k|| + size),     epsilon = 2 u, size = max ||r_i|| + 2 ||r_c||,
// which is added to the radius. The sums of radii are off by less than 8 epsilon times the radius. The means need no bound,
// because a ball is measured from the computed center, whatever it is. The linear refit adds epsilon (8 + n) (max ||t_i|| + max
// ||p||). It also adds 2 |e| r, as rotations with ||q_i||^2 = 1 + e are off by e (palette_rounding.hpp).
// Affine joints make images of up to F max ||p||, for Frobenius norms of up to F. They stretch r to s r, by adding (s - 1) r; the
// sums on the way are at most max(s, 1) r.
// Underflow: a sum of squares is off by less than 2^-147 and so a length by less than 2^-73; a radius has a few
// of them (balls/round_up.hpp). proptests/algorithms/bound_budgets.cpp derives what the slacks must be at least.
#pragma once

#include <limits>

#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/packs/lanes.hpp"
#include "algorithms/runtime/packs/row.hpp"
#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

// These return the slacks of Algorithm 1 and of the linear refit for a joint-set of so many joints, as shares of the lengths
// above.
constexpr float algorithm1_slack(int joints) {
  return std::numeric_limits<float>::epsilon() * static_cast<float>(64 + 2 * joints);
}
constexpr float linear_refit_slack(int joints) { return std::numeric_limits<float>::epsilon() * static_cast<float>(8 + joints); }
inline constexpr float refit_radius_stretch = 1 + 8 * std::numeric_limits<float>::epsilon();
inline constexpr float underflow_slack = underflow_of_distance<float>();  // of each radius

// FrameNumbers has the numbers of the joint-sets in one frame. For spherical blending they are r_c (3), size (1), then q_i (4)
// and r_i (3) of each joint. For linear blending they are slack (1), the factor that stretches r (1), then the rows of R_i and
// t_i, (3 + 1) x 3, of each joint.
struct FrameNumbers {
  const float* numbers;
  const int* first;  // by joint-set
};

// A NodeBlock has nodes, or pieces of nodes, one in each lane, all moved by the same joint-sets. Its numbers are Lanes. First
// come p (3), r, and 1 / (number of weight vertices) if that is not the same in all lanes. Then each weight vertex of each
// joint-set has its weights but the last one. Beyond certain_weight_vertices these follow a 1, or a 0 where the lane has no such
// weight vertex and repeats another one.
struct NodeBlock {
  int first_set, set_count;  // in NodeBlocks::sets
  int first_data;            // in NodeBlocks::data
  int first_target;          // in NodeBlocks::targets, of pieces
  float share;               // 1 / (number of weight vertices), or 0 if it is among the numbers
};
inline constexpr int most_sets_of_whole_nodes = 3;
// A PieceTarget says which records are those of a piece's weight vertices.
struct PieceTarget {
  int first, last;
};
struct BlockSet {
  int joint_set, joint_count;
  int certain_weight_vertices, weight_vertex_count;  // the fewest and the most of any lane
};
struct NodeBlocks {
  const NodeBlock* blocks;
  int block_count;
  const BlockSet* sets;
  const Lanes<float>* data;
  const PieceTarget* targets;  // by lane
  int most_weight_vertices;    // of any block, in all of its sets
};

// Refits whole nodes. out gets the balls' x, y, z and radius, which are four Lanes for each block.
using RefitNodes = void (*)(const NodeBlocks& blocks, const FrameNumbers& frame, Lanes<float>* out);

// Refits pieces, which have one joint-set each. Writes the balls of their weight vertices, without r, to their records.
using RefitPieces = void (*)(const NodeBlocks& blocks, const FrameNumbers& frame, Row<float, 4>* records);

// The weight vertices of a MergedNode's pieces are merged. They are one record after the other. Records of radius minus infinity
// fill them up to a multiple of four. The node's ball is written as x, y, z and radius, in Lanes, from place on.
struct MergedNode {
  int first_record, weight_vertex_count;
  float radius;  // r
  int place;
};
using MergeNodes = void (*)(const MergedNode* nodes, int node_count, const Row<float, 4>* records, float* balls);

struct RefitKernels {
  RefitNodes spherical_nodes, linear_nodes;
  RefitPieces spherical_pieces, linear_pieces;
  MergeNodes merge;
};

namespace baseline {
extern const RefitKernels refit_kernels;
}
namespace avx2 {
extern const RefitKernels refit_kernels;
}
namespace avx512 {
extern const RefitKernels refit_kernels;
}

const RefitKernels& refit_kernels(Target target);

}  // namespace refitlab
