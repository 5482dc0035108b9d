// SPDX-License-Identifier: MIT
// These are the packs for the kernel of MotionBound. A lane holds a whole group of joint-sets, or a piece of a node.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/collide/motion_bound_piece_kernel.hpp"
#include "algorithms/runtime/collide/motion_piece.hpp"
#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// For each joint, rounding loses this share of all lengths; see motion_bound_kernel.hpp.
inline constexpr float lost_of_motion_bound = 0x1p-15;
// Float rounds the squared length of a quaternion. A defect up to the first number is surely within the limit of 1e-6, and one
// above the second surely is not.
inline constexpr float surely_rigid = 5e-7f, surely_not_rigid = 2e-6f;
// Squares of larger numbers may overflow, and squares of smaller numbers may underflow.
inline constexpr double largest_length = 1e15, least_length = 1e-18;

inline bool can_be_bounded(const Ball3<double>& ball) {
  return ball.center.cwiseAbs().maxCoeff() < largest_length && ball.radius < largest_length;
}

// Puts a ball in the reference pose, moved by at most most_motion_bound_joints joints, into a lane and into all lanes
// behind it, which later calls overwrite. For spherical skinning, to_prior is the distance from the ball's center to the
// prior of the rotation center; for other skinning it is 0.
void put_lane(MotionBoundPack& pack, int lane, std::span<const int> joints, const Ball3<double>& ball, double to_prior,
              int target);

// Returns packs of all pieces, for any skinning but Hejl's, whose rotation centers are not the balls' centers. The result
// is empty if a piece has too many joints or is too large.
std::vector<MotionBoundPiecePack> make_motion_bound_packs(const Character& character, std::span<const MotionPiece> pieces);

}  // namespace refitlab
