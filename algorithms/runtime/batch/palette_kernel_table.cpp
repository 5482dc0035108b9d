// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/palette_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const PaletteKernels& palette_kernels(Target target) { return REFITLAB_OF_TARGET(target, palette_kernels); }

}  // namespace refitlab
