#include "algorithms/runtime/collide/reach_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const ReachKernels& reach_kernels(Target target) { return REFITLAB_OF_TARGET(target, reach_kernels); }

}  // namespace refitlab
