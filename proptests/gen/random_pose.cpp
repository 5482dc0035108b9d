// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/random_pose.hpp"

namespace proptests::gen {

using namespace refitlab;

Quaternion<double> random_rotation(std::mt19937& random, double spread) {
  std::normal_distribution<double> normal;
  Quaternion<double> q{1, spread * normal(random), spread * normal(random), spread * normal(random)};
  q.normalize();
  return q;
}

RigidTransform<double> random_placement(std::mt19937& random, double far) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return {random_rotation(random, 1), Point3(x, y, z) * far};
}

RigidTransform<double> near_or_far_placement(std::mt19937& random) {
  const double far = random() % 4 == 0 ? 1e6 : 2;
  return random_placement(random, far);
}

Pose random_pose(const SkinnedMesh& model, std::mt19937& random, double spread) {
  std::normal_distribution<double> normal;
  Pose pose = reference_pose(model);
  for (auto& t : pose) {
    t.rotation = random_rotation(random, spread);
    t.translation = Point3(normal(random), normal(random), normal(random)) * 0.2;
  }
  return pose;
}

void spoil_lengths(Pose& pose, std::mt19937& random) {
  std::uniform_real_distribution<double> off(-4.9e-7, 4.9e-7);
  for (auto& t : pose) t.rotation *= 1 + off(random);
}

}  // namespace proptests::gen
