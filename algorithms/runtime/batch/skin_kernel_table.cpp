// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/skin_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const SkinKernels& skin_kernels(Target target) { return REFITLAB_OF_TARGET(target, skin_kernels); }

}  // namespace refitlab
