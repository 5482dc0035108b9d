// SPDX-License-Identifier: MIT
// JointAnchors are balls around points that joints move, by joint, as the kernel of PoseChange reads them.
#pragma once

#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "algorithms/runtime/packs/lanes.hpp"

namespace refitlab {

struct JointAnchors {
  // Rows of x, y, z and radius, stride numbers apart. A joint without points has a negative radius, and so has what is behind the
  // last joint.
  std::vector<Lanes<float>> numbers;
  int joint_count = 0, stride = 0;
  double farthest = 0;  // the greatest distance from the origin of a point or of a ball's center

  const float* rows() const { return numbers.data()->lane.data(); }
};

// points are those of each joint, in the reference pose. If some are too large for float, radii may be infinite.
JointAnchors make_joint_anchors(const std::vector<std::vector<Point3>>& points);

}  // namespace refitlab
