#include "algorithms/batch/skin_kernel.hpp"

namespace refitlab {

const SkinKernels& skin_kernels(Target target) {
  switch (target) {
#ifdef REFITLAB_X86_TARGETS
    case Target::avx2: return avx2::skin_kernels;
    case Target::avx512: return avx512::skin_kernels;
#endif
    default: return baseline::skin_kernels;
  }
}

}  // namespace refitlab
