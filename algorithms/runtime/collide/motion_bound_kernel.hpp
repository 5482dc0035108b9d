// SPDX-License-Identifier: MIT
// The kernel of MotionBound. It handles all joints side by side, and then sixteen groups of joint-sets side by side.
//
// Rounding. Let u = 2^-24. When a joint's quaternion and the placement's come as floats, they have an error of u a
// component. Their product has 6 u a component, so the total is 12 u. A point f itself has an error of 2 u ||f||. Turned
// with this quaternion, its error is at most 4 * 12 u ||f||, and 20 u ||f|| from turning. The joint's translation t has the
// same errors, and the sum of both has u: together below 80 u (||f|| + ||t||). Each quaternion whose squared length has an
// error of 1e-6 turns f and t with an error of 2e-6 = 34 u of them. There are up to three: the joint's, the placement's
// and, in blending, the skinning's. So an image has an error of e < 182 u (||f|| + ||t||). A, of n images, has an error of
// at most sqrt(n (n - 1) / 2) 2 e, and its factor is less than 0.82. So the total error of a bound is below (1 + 1.16 n [n
// > 1]) e < 512 u n (||f|| + ||t||) = lost n (||f|| + ||t||). A^2 = n sum ||y_k||^2 - ||sum y_k||^2, where y_k = x_k - x_1
// are the images seen from the first. n sum ||y_k||^2 is at most n A^2, because these squares are among the summands of
// A^2. So A is computed within n (n + 8) u / 2 of itself, a small part of error_share A. A dot product has an error of 64
// u, including that of lengths, and c is lowered by `positive`, which is more. Products and sums that are fused
// (CMakeLists.txt) lose less. proptests/algorithms/bound_budgets.cpp derives all of these from the templates.
#pragma once

#include <cstdint>

#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

inline constexpr int motion_bound_lanes = 16;
inline constexpr int most_motion_bound_joints = 8;  // of a group in a pack

// Returns the share of A that allows for errors where no squared length of a quaternion differs from 1 by more than defect. Where
// rotation_center takes a direction as undetermined, A lacks up to 2e-3 of the distance from f to the prior for each joint. A
// single joint, about the prior, turns f by up to 2 defect of that distance away from its image. The center itself may be 3e4 A
// away, and 2 defect of that distance is the largest part of this share of A.
constexpr float error_share(double defect) { return static_cast<float>(0x1p-8 + 6e4 * defect); }

// These are plain arrays by lane. Lanes beyond the last group repeat it, and slots beyond a group's last joint repeat its
// first one.
struct MotionBoundPack {
  alignas(64) std::int32_t joint[most_motion_bound_joints][motion_bound_lanes];
  alignas(64) float center[3][motion_bound_lanes];  // f
  alignas(64) float radius[motion_bound_lanes];     // with an allowance for rounding
  alignas(64) float unsolved[motion_bound_lanes];   // what A may lack, see motion_bound_packs.cpp
  alignas(64) float joint_count[motion_bound_lanes];
  std::int32_t target[motion_bound_lanes];  // the group, or the box it belongs to
  // For each four lanes, this has the most joints of any group in them and behind, or 0 if there is no group.
  std::int32_t slot_count[motion_bound_lanes / 4];

  int slots_from(int lane) const { return slot_count[lane / 4]; }
};

struct MotionBoundBox {
  float low[4];   // the low x, y, z of all bounded groups, turned by the placement but not moved; then minus the largest
                  // ||t||^2 of the joints' translations, or minus infinity if one is beyond 1e30 or no number
  float high[4];  // the high x, y, z; then the largest | ||q||^2 - 1 | of the quaternions, or 1 if that is greater or no number
  // For each lane, these are the least c and the largest A of some groups. All lanes together have those of all groups. If a bound
  // is not known for some group, a cosine is not positive, or no number.
  alignas(64) float cosine[motion_bound_lanes], spread[motion_bound_lanes];
};

struct MotionBoundKernels {
  // Makes the bounds of all packs. pose has a quaternion, a translation and an unused number for each joint. rotation is
  // the placement's. numbers has room for eight numbers of each of joint_stride joints (a multiple of 32, not less than the
  // number of joints), in an order of the kernels' own. unbounded has, for each pack, a bit for each lane without a known bound,
  // the first lowest. deviates says whether blends deviate from linear ones.
  void (*bound)(const double* pose, int joint_count, const double* rotation, const MotionBoundPack* packs, int pack_count,
                bool deviates, float* numbers, int joint_stride, MotionBoundBox& out, std::uint32_t* unbounded);
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
