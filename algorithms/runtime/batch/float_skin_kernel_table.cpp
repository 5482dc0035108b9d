// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/float_skin_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

FloatSkin float_skin(Target target) { return REFITLAB_OF_TARGET(target, float_skin); }

}  // namespace refitlab
