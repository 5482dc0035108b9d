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

Pose random_pose(const SkinnedMesh& model, std::mt19937& random, double spread) {
  std::normal_distribution<double> normal;
  Pose pose = reference_pose(model);
  for (auto& t : pose) {
    t.rotation = random_rotation(random, spread);
    t.translation = Point3(normal(random), normal(random), normal(random)) * 0.2;
  }
  return pose;
}

}  // namespace proptests::gen
