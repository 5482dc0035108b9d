#include "algorithms/runtime/batch/pose_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

PoseRun pose_run(Target target) { return REFITLAB_OF_TARGET(target, pose_run); }

}  // namespace refitlab
