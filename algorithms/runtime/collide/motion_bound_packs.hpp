// SPDX-License-Identifier: MIT
// What joints reach, in packs for the kernel of MotionBound: whole groups of joint-sets, or pieces of nodes.
#pragma once

#include "algorithms/runtime/collide/motion_bound_piece_kernel.hpp"
#include "algorithms/runtime/collide/simplex_pieces.hpp"

namespace refitlab {

// Of all sizes, for each joint: what is lost, see motion_bound_kernel.hpp.
inline constexpr float lost_of_motion_bound = 0x1p-15;
// Of what is greater squares may overflow, and of what is less they may underflow.
inline constexpr double largest_reach = 1e15, least_reach = 1e-18;

inline bool can_be_reached(const Ball3<double>& ball) {
  return ball.center.cwiseAbs().maxCoeff() < largest_reach && ball.radius < largest_reach;
}

// Puts a ball in the reference pose, moved by at most most_motion_bound_joints joints, into a lane and all behind it, which
// others overwrite. to_prior: from its center to the prior of their rotation center, in other than spherical skinning
// 0.
void put_lane(MotionBoundPack& pack, int lane, std::span<const int> joints, const Ball3<double>& ball, double to_prior,
              int target);

// All pieces, for any skinning but Hejl's, whose rotation centers are not the balls'. Empty if a piece has too many
// joints or is too large.
std::vector<MotionBoundPiecePack> make_motion_bound_packs(const Character& character, std::span<const SimplexPiece> pieces);

}  // namespace refitlab
