// The kernel of PosePacks: the frame's data of eight joint-sets of the same number of joints at a time.
#pragma once

#include <cstdint>

#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

inline constexpr int pose_lanes = 8;
inline constexpr int most_pose_joints = 4;  // of a joint-set in a pack

// By lane. Lanes beyond the last joint-set repeat it.
struct PosePack {
  alignas(64) double prior[3][pose_lanes];  // of the rotation center
  std::int32_t joint[most_pose_joints][pose_lanes];
  std::int32_t set[pose_lanes], first_slot[pose_lanes];  // where its own and its joints' data go
};

// The arrays of a SkinningPose, as numbers.
struct PoseNumbers {
  double* rotation_centers;  // 3 each
  double* transforms;        // 8 each: a quaternion, a translation, an unused one
  double* center_images;     // 3 each
  double* duals;             // 4 each
};

// posture: by joint, as the transforms. If are_centers_fixed, the priors are the rotation centers.
using PoseRun = void (*)(const PosePack* packs, int count, int joints, bool are_centers_fixed, const double* posture,
                         const PoseNumbers& out);

namespace baseline {
extern const PoseRun pose_run;
}
namespace avx2 {
extern const PoseRun pose_run;
}
namespace avx512 {
extern const PoseRun pose_run;
}

PoseRun pose_run(Target target);

}  // namespace refitlab
