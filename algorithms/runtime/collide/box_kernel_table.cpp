// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const BoxKernels& box_kernels(Target target) { return REFITLAB_OF_TARGET(target, box_kernels); }

}  // namespace refitlab
