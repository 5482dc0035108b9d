// SPDX-License-Identifier: GPL-3.0-or-later
// A twist is the turn of one joint about its bone, where linear blending collapses and the printed refit misses vertices.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// Returns the unit vector along the joint's bone in the reference pose. It goes from its origin towards the mean of its
// children's origins, or away from its parent's if it has no children.
Point3 bone_axis(const SkinnedMesh& model, int joint);

// Turns one joint and all below it about the joint's bone axis as it is in the reference pose, before the pose.
Pose twisted(const SkinnedMesh& model, Pose pose, int joint, double radians);

// Does the same from the reference pose.
Pose twist_pose(const SkinnedMesh& model, int joint, double radians);

// Returns the joint whose twist shows the paper's Figure 5. It is a neck, else a head, spine or wrist by name, else the joint in
// the middle of the hierarchy.
int twist_joint(const SkinnedMesh& model);

}  // namespace refitlab
