// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/deformed_pose.hpp"

#include <utility>

namespace refitlab {

DeformedPose deformed_pose(const SkinnedMesh& mesh, AffinePose joints, std::vector<double> weights) {
  SplitPose phases = split(mesh, joints);
  return {std::move(phases.pose), std::move(phases.scales), std::move(joints), std::move(weights)};
}

DeformedFrame frame_of(const Character& c, const DeformedPose& pose, Skinning skinning) {
  if (skinning == Skinning::linear && !pose.joints.empty())
    return {{pose.weights, {}}, make_skinning_palette(c.mesh, c.sets, pose.joints)};
  return {{pose.weights, pose.scales}, make_skinning_palette(c.mesh, c.sets, pose.rigid, skinning)};
}

}  // namespace refitlab
