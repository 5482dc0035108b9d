// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/palette_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

PaletteRun palette_run(Target target) { return REFITLAB_OF_TARGET(target, palette_run); }

}  // namespace refitlab
