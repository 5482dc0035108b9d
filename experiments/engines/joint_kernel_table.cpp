// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/packs/kernel_table.hpp"
#include "experiments/engines/joint_kernel.hpp"

namespace refitlab {

const JointKernels& joint_kernels(Target target) { return REFITLAB_OF_TARGET(target, joint_kernels); }

}  // namespace refitlab
