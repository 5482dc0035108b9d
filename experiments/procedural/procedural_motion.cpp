// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/procedural/procedural_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

Quaternion<double> turn(const Point3& axis, double degrees) {
  const double half = degrees * std::numbers::pi / 360;
  const Point3 v = std::sin(half) / norm(axis) * axis;
  return {std::cos(half), v[0], v[1], v[2]};
}

Pose pose(const std::vector<Joint>& joints, const Turns& turns, const Point3& offset) {
  const DefaultFloatEnvironment environment;
  for (const auto& turned : turns)
    if (std::none_of(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == turned.first; }))
      throw ModelError("generated motion", "joint " + turned.first, "no such joint");
  Pose c;
  for (const Joint& joint : joints) {
    RigidTransform<double> local;
    if (const auto found = turns.find(joint.name); found != turns.end())
      local = {found->second, joint.origin - rotate(found->second, joint.origin)};
    if (joint.parent < 0) local.translation += offset;
    else local = compose(c[joint.parent], local);
    local.rotation /= norm(local.rotation);
    c.push_back(local);
  }
  return c;
}

double periodic(const std::vector<double>& values, double phase) {
  const int n = int(values.size());
  const double position = (phase - std::floor(phase)) * n;
  const int i = int(position);
  const double t = position - i;
  const auto value = [&](int k) { return values[(k + n) % n]; };
  const double a = value(i - 1), b = value(i), c = value(i + 1), d = value(i + 2);
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

Pose on_the_ground(Pose pose, const std::vector<Sole>& soles) {
  double lowest = 1e9;
  for (const Sole& sole : soles) lowest = std::min(lowest, apply(pose[sole.joint], sole.point)[1]);
  for (auto& c : pose) c.translation[1] -= lowest;
  return pose;
}

}  // namespace refitlab
