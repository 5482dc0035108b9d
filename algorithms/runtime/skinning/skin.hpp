// Skinning a whole model: the deformed vertices of a posture.
#pragma once

#include "algorithms/runtime/skinning/skinning_pose.hpp"

namespace refitlab {

// By vertex, in model space of the animated posture. pose must come from make_skinning_pose with the same skinning.
std::vector<Point3> skin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPose<double>& pose, Skinning skinning);

}  // namespace refitlab
