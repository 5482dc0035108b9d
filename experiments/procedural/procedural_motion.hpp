// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of the built-in models: joints turned about their origins through the hierarchy.
#pragma once

#include <map>

#include "algorithms/model/model.hpp"

namespace refitlab {

// A turn about an axis of model space (any length but zero), in degrees, right-handed.
Quaternion<double> turn(const Point3& axis, double degrees);

// Turns of joints against their parents, by joint name; joints that are not named keep theirs.
using Turns = std::map<std::string, Quaternion<double>>;

// C_j of every joint; the root joint moves by `offset` besides. A turn is about axes through the joint's origin that
// are parallel to those of model space in the reference pose. Throws ModelError for a name that is no joint's.
Pose pose(const std::vector<Joint>& joints, const Turns& turns, const Point3& offset = Point3::Zero());

// A smooth curve of period 1 (Catmull-Rom) that at phase i / n takes the i-th of n values.
double periodic(const std::vector<double>& values, double phase);

// The pose, moved up or down until the lowest of the points (of the reference pose, with their joints) is on y =
// 0.
struct Sole {
  int joint;
  Point3 point;
};
Pose on_the_ground(Pose pose, const std::vector<Sole>& soles);

}  // namespace refitlab
