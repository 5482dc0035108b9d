// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_bound_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const MotionBoundKernels& motion_bound_kernels(Target target) { return REFITLAB_OF_TARGET(target, motion_bound_kernels); }

}  // namespace refitlab
