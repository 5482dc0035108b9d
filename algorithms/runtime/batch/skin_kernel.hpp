// SPDX-License-Identifier: MIT
// The kernel of batch skinning takes vertices of one joint-set, a vertex a lane.
#pragma once

#include "algorithms/runtime/packs/lanes.hpp"
#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

// JointSetNumbers is a joint-set's PaletteEntry as numbers.
struct JointSetNumbers {
  int joint_count;
  const double* transforms;  // each a quaternion and a translation, transform_stride apart
  int transform_stride;
  const double* rotation_center;
  const double* center_images;  // 3 each
  const double* duals;          // 4 each
  const double* maps;           // of affine joints: 12 each, the columns and the offset; all other arrays do not matter then
};

// data has one block of vertices after the other. Each block has x, y, z and the weights by joint of the set. The images go to
// out, which has x, y, z for each block.
using SkinRun = void (*)(const JointSetNumbers& joints, const Lanes<double>* data, int block_count, Lanes<double>* out);

struct SkinKernels {
  SkinRun linear, spherical, dual_quaternion, affine;  // affine: linear skinning by affine joints
};

namespace baseline {
extern const SkinKernels skin_kernels;
}
namespace avx2 {
extern const SkinKernels skin_kernels;
}
namespace avx512 {
extern const SkinKernels skin_kernels;
}

const SkinKernels& skin_kernels(Target target);

}  // namespace refitlab
