// SPDX-License-Identifier: GPL-3.0-or-later
// Weighted radii say how far volumes that joints carry must be grown so that linearly skinned vertices stay inside a box around
// all of them. This is less than it takes to hold every vertex in every volume (a4_joint_volumes). A vertex that a far joint
// moves a little no longer makes that joint's volume large. The radii solve one inequality a vertex.
#pragma once

#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// A WeightedDistance is a joint's share of a vertex's inequality.
struct WeightedDistance {
  int joint;
  double weight, distance;  // of v from the joint's volume
};

// Returns radii by joint, from those that are given, which are at least 0: they are raised where an inequality by vertex lacks,
// then lowered one by one, until none can be less by itself. Those of joints in no inequality become 0.
std::vector<double> weighted_radii(const std::vector<std::vector<WeightedDistance>>& inequalities, std::vector<double> radii);

// Returns, by joint, the vertices that it moves with this weight or more. If there are none, they are those that it moves more
// than other joints do, or else the one that it moves most. A joint that moves no vertex has none.
std::vector<std::vector<Point3>> own_vertices(const SkinnedMesh& mesh, double least_weight);

}  // namespace refitlab
