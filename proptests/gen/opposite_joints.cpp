// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/opposite_joints.hpp"

#include <cmath>
#include <random>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace proptests::gen {

using namespace refitlab;

OppositeJoints opposite_joints(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1), weight(0, 1);
  const int joints = 2 + static_cast<int>(random() % 3);
  OppositeJoints out;
  SkinnedMesh& m = out.mesh;
  m.name = "soup";
  for (int j = 0; j < joints; ++j) m.joints.push_back({"joint " + std::to_string(j), j - 1, {u(random), u(random), u(random)}});
  for (int v = 0; v < 60; ++v) {
    m.vertices.push_back({u(random), u(random), u(random)});
    std::vector<std::pair<int, double>> weights;
    for (int j = 0; j < joints; ++j) weights.emplace_back(j, 0.02 + std::pow(weight(random), 3));
    m.influences.emplace_back();
    for (const auto& [joint, w] : quantize_weights(weights)) m.influences.back().push_back({joint, w});
    if (v % 3 == 2) m.triangles.push_back({v - 2, v - 1, v});
  }
  out.pose = reference_pose(m);
  for (int j = 1; j < joints; ++j) {
    const double near[] = {0.02, 0.2, 0.6}, w = near[random() % 3], sign = j % 2 ? 1 : -1;
    out.pose[j].rotation = {w, sign * std::sqrt(1 - w * w), 0.1 * u(random), 0.1 * u(random)};
    out.pose[j].rotation.normalize();
  }
  return out;
}

const char* label_of(const OppositeJoints& soup) {
  auto transforms = soup.pose;
  make_signs_consistent<double>(transforms);
  for (const auto& a : transforms)
    for (const auto& b : transforms)
      if (dot(a.rotation, b.rotation) < 0) return "beyond a right angle";
  return "within a right angle";
}

}  // namespace proptests::gen
