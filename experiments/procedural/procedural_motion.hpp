// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of the built-in models turn joints about their origins through the hierarchy.
#pragma once

#include <map>

#include "algorithms/model/model.hpp"

namespace refitlab {

// Returns a turn about an axis of model space (any length but zero), in degrees, right-handed.
Quaternion<double> turn(const Point3& axis, double degrees);

// Turns are those of joints against their parents, by joint name. Joints that are not named do not turn.
using Turns = std::map<std::string, Quaternion<double>>;

// Returns C_j of every joint. The root joint moves by `offset` besides. A turn is about axes through the joint's origin that are
// parallel to those of model space in the reference pose. Throws ModelError for a name that is no joint's.
Pose pose(const std::vector<Joint>& joints, const Turns& turns, const Point3& offset = Point3::Zero());

// Evaluates a smooth curve of period 1 (Catmull-Rom) that takes the i-th of n values at phase i / n.
double periodic(const std::vector<double>& values, double phase);

// The pose is moved up or down until the lowest of the points (of the reference pose, with their joints) is on y = 0.
struct Sole {
  int joint;
  Point3 point;
};
Pose on_the_ground(Pose pose, const std::vector<Sole>& soles);

}  // namespace refitlab
