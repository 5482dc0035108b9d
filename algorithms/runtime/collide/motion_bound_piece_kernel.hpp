// SPDX-License-Identifier: MIT
// The kernel that bounds nodes from their joints alone: as that of MotionBound, but by target, and by a ball and a box.
//
// By b7_motion_bound with f = v a vertex is within s A(v) of the hull of its images: so it is in the hull of the images of a
// box around all of them, blown up by s (A(m) + sqrt(2 n (n - 1) (1 - c^2)) ||h||), m its middle and h half its
// diagonal. Along an axis the image of the box reaches as far as that of m and |R| h.
//
// Rounding, with the names of motion_bound_kernel.hpp. A rotation's matrix is off by 48 u from the quaternion and, element by
// element, by 5 u at most: below 60 u in all, and an image by less than the 80 u found there. |R| h is off by 60 u
// ||h||, 5 u ||h|| and 102 u ||h|| for lengths that are not 1: below lost ||h||. c is lowered by more than it may be
// off, so that 1 - c^2 is not too small, and its root's rounding is within that of spin.
#pragma once

#include "algorithms/runtime/collide/flipped_box.hpp"
#include "algorithms/runtime/collide/motion_bound_kernel.hpp"

namespace refitlab {

// A piece in a lane: its ball, and its box in the reference pose.
struct MotionBoundPiecePack {
  MotionBoundPack ball;
  alignas(64) float box_center[3][motion_bound_lanes], half[3][motion_bound_lanes];
  alignas(64) float lost[motion_bound_lanes];  // of the box in float
  alignas(64) float spin[motion_bound_lanes];  // sqrt(2 n (n - 1)) times half its diagonal, n the joints
  alignas(64) float box_unsolved[motion_bound_lanes];
};

// Merges the bounds of pieces into boxes[target], turned by the placement, not moved. numbers: as MotionBoundKernels::bound
// left them for this pose and placement; off: off_of_reach. False if nothing is known of some lane.
using BoundMotionPieces = bool (*)(float* numbers, int joint_count, int joint_room, const MotionBoundPiecePack* packs,
                                   int pack_count, bool deviates, float off, FlippedBox* boxes);

namespace baseline {
extern const BoundMotionPieces bound_motion_pieces;
}
namespace avx2 {
extern const BoundMotionPieces bound_motion_pieces;
}
namespace avx512 {
extern const BoundMotionPieces bound_motion_pieces;
}

BoundMotionPieces bound_motion_pieces(Target target);

}  // namespace refitlab
