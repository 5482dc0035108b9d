// SPDX-License-Identifier: MIT
// The kernel of PoseChange. It handles all joints side by side.
//
// Rounding, with the names of motion_bound_kernel.hpp. The images of both poses have errors of e each, and so d is off by both. Two
// quaternions that come as floats have errors of u each, their difference has one of 2 u, and lengths that are off by 1e-6 have
// another one of 2e-6 / 2: ||q' - q|| is off by less than lost_of_turn, and a cosine by less than lost_of_cosine. A box grows by
// d + (s + error_share) (A + n d), so an error of d counts at most 1 + 0.82 n times. Besides, the later pose has the errors of any
// motion bound. lost_of_growth is more than all of these. proptests/algorithms/bound_budgets.cpp derives it.
#pragma once

#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

// Rows of arrays for PoseChangeKernels. A row has a number of each joint.
inline constexpr int rows_of_anchors = 4;  // x, y and z of a point, and a radius, which is negative if the joint is not looked at
inline constexpr int rows_of_kept_pose = 7;  // a quaternion, and x, y and z of the point's image

inline constexpr double lost_of_turn = 2e-6, lost_of_cosine = 1e-5;
// Returns what rounding may lose of the growth, beside a small share of it. joints are those of a group, point is the greatest length
// of a point f or of an anchor, and earlier and later are those of the joints' translations.
inline double lost_of_growth(double joints, double point, double earlier, double later) {
  return 0x1p-14 * joints * (2 * point + earlier + later);
}

// These are the greatest numbers of any joint. The first two are of joints that are looked at.
struct JointChange {
  float moved;             // how far the joint has carried points within the radius of its anchor elsewhere
  float turned;            // ||q' - q||, of the sign of q' that makes it less
  float squared_farthest;  // ||t||^2 of its translation, or infinity if one is beyond 1e30 or no number
  float defect;            // | ||q||^2 - 1 |, or 1 if one is greater or no number
};

// pose has a quaternion, a translation and an unused number for each joint. Rows are joint_stride numbers apart, a multiple of 32
// that is not less than the number of joints. Anchors behind the last joint have negative radii.
struct PoseChangeKernels {
  void (*keep)(const double* pose, int joint_count, int joint_stride, const float* anchors, float* kept);
  void (*compare)(const double* pose, int joint_count, int joint_stride, const float* anchors, const float* kept,
                  JointChange& out);
};

namespace baseline {
extern const PoseChangeKernels pose_change_kernels;
}
namespace avx2 {
extern const PoseChangeKernels pose_change_kernels;
}
namespace avx512 {
extern const PoseChangeKernels pose_change_kernels;
}

const PoseChangeKernels& pose_change_kernels(Target target);

}  // namespace refitlab
