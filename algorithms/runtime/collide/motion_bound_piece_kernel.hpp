// SPDX-License-Identifier: MIT
// This kernel bounds nodes from their joints alone. It works like that of MotionBound, but by target, and with a ball and a box.
//
// By b7_motion_bound with f = v, a vertex is within s A(v) of the hull of its images. So it is in the hull of the images of
// a box around all vertices, inflated by s (A(f) + sqrt(2 n (n - 1) (1 - c^2)) r), where f is the center of the ball and r its
// radius. Along an axis, the image of the box extends by |R| h around that of its center, where h is half its diagonal. Where
// weights are known to be no less than some m, each hull is that of the images shrunk by 1 - sum m and moved by the sum of m times
// an image.
//
// Rounding, with the names of motion_bound_kernel.hpp. The matrix of a rotation has an error of 48 u from the quaternion
// and, element by element, of at most 5 u: together below 60 u. An image has an error of less than the 80 u found there.
// |R| h has errors of 60 u ||h||, of 5 u ||h||, and of 102 u ||h|| for lengths that are not 1: together below lost ||h||. c
// is lowered by more than its error, so that 1 - c^2 is not too small. The rounding of its root is within that of spin. Least
// weights are rounded down, and what they leave of 1 has an error of u. The sums with them have at most 2 n + 3 roundings of images.
#pragma once

#include "algorithms/runtime/collide/flipped_box.hpp"
#include "algorithms/runtime/collide/motion_bound_kernel.hpp"

namespace refitlab {

// Each lane has a piece, with its ball and its box in the reference pose.
struct MotionBoundPiecePack {
  MotionBoundPack ball;
  alignas(64) float box_center[3][motion_bound_lanes], half[3][motion_bound_lanes];
  alignas(64) float lost[motion_bound_lanes];           // of the box in float
  alignas(64) float spin[motion_bound_lanes];           // sqrt(2 n (n - 1)) times the ball's radius, n the joints
  alignas(64) float unsolved_more[motion_bound_lanes];  // by how much more no vertex is unsolved than the ball's center
  // These are of the weights, by slot where they are of a joint. A slot beyond the last joint has the least weight 0.
  alignas(64) float least[most_motion_bound_joints][motion_bound_lanes], rest[motion_bound_lanes];  // rest is 1 - their sum
  alignas(64) float products[motion_bound_lanes], squared_products[motion_bound_lanes];
};

// Merges the bounds of pieces into boxes[target], turned by the placement but not moved. numbers are as
// MotionBoundKernels::bound of the same target left them for this pose and placement, and off is error_share. Returns false if no
// bound is known for some lane.
using BoundMotionPieces = bool (*)(float* numbers, int joint_count, int joint_stride, const MotionBoundPiecePack* packs,
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
