// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/pose_change_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const PoseChangeKernels& pose_change_kernels(Target target) { return REFITLAB_OF_TARGET(target, pose_change_kernels); }

}  // namespace refitlab
