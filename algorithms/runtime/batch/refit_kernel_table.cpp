// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/refit_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const RefitKernels& refit_kernels(Target target) { return REFITLAB_OF_TARGET(target, refit_kernels); }

}  // namespace refitlab
