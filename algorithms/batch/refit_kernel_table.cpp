#include "algorithms/batch/refit_kernel.hpp"

namespace refitlab {

const RefitKernels& refit_kernels(Target target) {
  switch (target) {
#ifdef REFITLAB_X86_TARGETS
    case Target::avx2: return avx2::refit_kernels;
    case Target::avx512: return avx512::refit_kernels;
#endif
    default: return baseline::refit_kernels;
  }
}

}  // namespace refitlab
