// SPDX-License-Identifier: GPL-3.0-or-later
// Weighted radii: how far volumes that joints carry must be grown so that linearly skinned vertices stay inside a box around
// all of them, which is less than it takes to hold every vertex in every volume
// (a4_joint_volumes). A vertex that a far joint moves a little no longer makes that joint's volume large. The radii solve one
// inequality a vertex.
#pragma once

#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// A joint's share of a vertex's inequality.
struct WeightedDistance {
  int joint;
  double weight, distance;  // of v from the joint's volume
};

// Radii by joint, from those that are given, which are at least 0: raised where an inequality by vertex lacks, then lowered one by
// one, until none can be less by itself. Those of joints in no inequality become 0.
std::vector<double> weighted_radii(const std::vector<std::vector<WeightedDistance>>& inequalities, std::vector<double> radii);

// By joint the vertices that it moves with this weight or more, or most of its vertex's joints where no vertex has that;
// of a joint that moves none so, the one that it moves most; none of a joint that moves no vertex.
std::vector<std::vector<Point3>> own_vertices(const SkinnedMesh& mesh, double least_weight);

}  // namespace refitlab
