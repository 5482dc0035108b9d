#include "algorithms/batch/pose_kernel.hpp"

namespace refitlab {

PoseRun pose_run(Target target) {
  switch (target) {
#ifdef REFITLAB_X86_TARGETS
    case Target::avx2:
      return avx2::pose_run;
    case Target::avx512:
      return avx512::pose_run;
#endif
    default:
      return baseline::pose_run;
  }
}

}  // namespace refitlab
