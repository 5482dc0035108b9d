// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_pair_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

const ClusterPairKernels& cluster_pair_kernels(Target target) { return REFITLAB_OF_TARGET(target, cluster_pair_kernels); }

}  // namespace refitlab
