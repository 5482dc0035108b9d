// SPDX-License-Identifier: MIT
// The kernel of MotionBound: sixteen groups of joint-sets side by side, and before that all joints side by side.
//
// Rounding. u = 2^-24. A joint's quaternion and the placement's are off by u a component when they come as floats,
// their product by 6 u a component, 12 u in all. With it a point f, itself off by 2 u ||f||, is turned wrongly by at
// most 4 * 12 u ||f||, and by 20 u ||f|| in turning; the joint's translation t likewise, and the sum of both by u:
// below 80 u (||f|| + ||t||). Quaternions whose squared lengths are off by 1e-6 each turn by what is off by 2e-6 = 34 u
// of f and t, the joint's, the placement's and, in blending, the skinning's: an image is off by e < 182 u (||f|| +
// ||t||). A, of n images, is off by at most sqrt(n (n - 1) / 2) 2 e, and what it is multiplied by is less than 0.82:
// all that is lost of a bound is below (1 + 1.16 n [n > 1]) e < 512 u n (||f|| + ||t||) = lost n (||f|| + ||t||). A^2 =
// n sum ||y_k||^2 - ||sum y_k||^2, with y_k = x_k - x_1 the images seen from the first. n sum ||y_k||^2 is at most n
// A^2, since A^2 has the squares among its summands: A comes out within n (n + 8) u / 2 of itself, a small part of
// off_of_reach A. A dot product is off by 64 u, lengths included, and c is lowered by `positive`, which is more.
// Products and sums that are fused (CMakeLists.txt) lose less.
#pragma once

#include <cstdint>

#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

inline constexpr int motion_bound_lanes = 16;
inline constexpr int most_motion_bound_joints = 8;  // of a group in a pack

// The share of A for what is off where no squared length of a quaternion is off by more than defect. Where
// rotation_center takes a direction as undetermined, A lacks up to 2e-3 of f's distance from the prior for each joint;
// and a single joint, about the prior, turns f by up to 2 defect of that distance elsewhere than its image.
// And the center itself may be 3e4 A away, where 2 defect of it are the most of this share of A.
constexpr float off_of_reach(double defect) { return static_cast<float>(0x1p-8 + 6e4 * defect); }

// By lane, plain arrays. Lanes beyond the last group repeat it, and slots beyond a group's last joint its first one.
struct MotionBoundPack {
  alignas(64) std::int32_t joint[most_motion_bound_joints][motion_bound_lanes];
  alignas(64) float center[3][motion_bound_lanes];  // f
  alignas(64) float radius[motion_bound_lanes];     // with what may be lost
  alignas(64) float unsolved[motion_bound_lanes];   // what A may lack, see reach.cpp
  alignas(64) float joint_count[motion_bound_lanes];
  std::int32_t target[motion_bound_lanes];  // the group, or the box it belongs to
  int slot_count;                           // the most joints of any lane
};

struct ReachBounds {
  float low[4];   // of what is bounded of all groups, x, y, z, turned by the placement, not moved; then - the largest
                  // ||t||^2 of the joints' translations, minus infinity if one is beyond 1e30 or no number
  float high[4];  // likewise; then the largest | ||q||^2 - 1 | of their quaternions, 1 if that is greater or no number
};

struct MotionBoundKernels {
  // Bounds of all packs. pose: by joint, a quaternion, a translation and an unused number; rotation: the
  // placement's; numbers: room for eight numbers a joint, joint_room (a multiple of 32, not less than the joints)
  // apart; unbounded: by pack, a bit for each lane of which nothing is known, the first lowest. deviates: whether blends
  // deviation from linear ones.
  void (*bound)(const double* pose, int joint_count, const double* rotation, const MotionBoundPack* packs, int pack_count,
                bool deviates, float* numbers, int joint_room, ReachBounds& out, std::uint32_t* unbounded);
};

namespace baseline {
extern const MotionBoundKernels motion_bound_kernels;
}
namespace avx2 {
extern const MotionBoundKernels motion_bound_kernels;
}
namespace avx512 {
extern const MotionBoundKernels motion_bound_kernels;
}

const MotionBoundKernels& motion_bound_kernels(Target target);

}  // namespace refitlab
