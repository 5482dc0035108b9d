// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of boxes around whole characters makes the matrices of all joints in float, and the boxes around what joints carry,
// a joint a lane.
//
// A pose comes as quaternions; matrices are what engines have of it. All arrays are by blocks of Lanes<float>::count joints, each
// of them by number, then by joint, so that a kernel finds all numbers of a block from one address.
#pragma once

#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

// A joint has this many numbers. A matrix (R | t) is row by row. A box has its center and its half extents, and a rounded box a
// radius too. A capsule has the ends of its axis and its radius. A pose has a quaternion, a translation and an unused number.
inline constexpr int matrix_numbers = 12, box_numbers = 6, rounded_box_numbers = 7, capsule_numbers = 7, pose_numbers = 8;

// An empty volume has this extent, and no merged box grows by it.
inline constexpr float extent_of_nothing = -1e30f;

struct JointKernels {
  // pose has a quaternion, a translation and an unused number by joint.
  void (*matrices)(const double* pose, int joint_count, int blocks, float* matrices);
  // out gets the least x, y, z, then the greatest.
  void (*boxes)(const float* matrices, const float* boxes, int blocks, float* out);
  // These are grown along each axis by lost times the greatest absolute value of what comes out.
  void (*capsules)(const float* matrices, const float* capsules, int blocks, float lost, float* out);
  // are_balls says, by block, whether all half extents are 0, which then are not read.
  void (*rounded_boxes)(const float* matrices, const float* boxes, const unsigned char* are_balls, int blocks, float lost,
                        float* out);
};

namespace baseline {
extern const JointKernels joint_kernels;
}
namespace avx2 {
extern const JointKernels joint_kernels;
}
namespace avx512 {
extern const JointKernels joint_kernels;
}

const JointKernels& joint_kernels(Target target);

}  // namespace refitlab
