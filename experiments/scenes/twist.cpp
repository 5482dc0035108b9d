// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/twist.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace refitlab {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

Point3 bone_axis(const SkinnedMesh& model, int joint) {
  Point3 sum = Point3::Zero();
  int children = 0;
  for (const Joint& j : model.joints)
    if (j.parent == joint) sum += j.origin, ++children;
  const Point3& origin = model.joints[joint].origin;
  Point3 axis =
      children ? Point3(sum / children - origin) : Point3(origin - model.joints[std::max(0, model.joints[joint].parent)].origin);
  return axis.norm() > 0 ? Point3(axis.normalized()) : Point3::UnitY();
}

Pose twisted(const SkinnedMesh& model, Pose pose, int joint, double radians) {
  const Point3 axis = bone_axis(model, joint) * std::sin(radians / 2);
  const Point3& origin = model.joints[joint].origin;
  RigidTransform<double> turn;
  turn.rotation = {std::cos(radians / 2), axis[0], axis[1], axis[2]};
  turn.translation = origin - rotate(turn.rotation, origin);
  std::vector<bool> below(model.joints.size());
  for (std::size_t j = 0; j < model.joints.size(); ++j) {  // parents come first
    const int parent = model.joints[j].parent;
    below[j] = static_cast<int>(j) == joint || (parent >= 0 && below[parent]);
    if (below[j]) pose[j] = compose(pose[j], turn);
  }
  return pose;
}

Pose twist_pose(const SkinnedMesh& model, int joint, double radians) {
  return twisted(model, reference_pose(model), joint, radians);
}

int twist_joint(const SkinnedMesh& model) {
  for (const char* part : {"neck", "hals", "head", "kopf", "wrist", "spine"})
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (lower(model.joints[j].name).find(part) != std::string::npos && model.joints[j].parent >= 0) return static_cast<int>(j);
  return static_cast<int>(model.joints.size() / 2);
}

}  // namespace refitlab
