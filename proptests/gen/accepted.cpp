// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/accepted.hpp"

#include <rapidcheck.h>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "proptests/gen/random_pose.hpp"

namespace proptests::gen {

using namespace refitlab;

namespace {

constexpr double edge = 1e-6 - 1e-14;  // of | ||q||^2 - 1 |

template <class T, std::size_t n>
T one_of(const T (&list)[n], std::mt19937& random) {
  return list[random() % n];
}

Quaternion<double> random_turn(std::mt19937& random) {
  if (random() % 4 == 0) return random_rotation(random, 1);
  Quaternion<double> half_turn{0, 0, 0, 0};
  half_turn[1 + static_cast<int>(random() % 3)] = random() % 2 ? 1 : -1;
  return half_turn;
}

void add_joints(SkinnedMesh& m, int count, const Point3& origin) {
  for (int j = 0; j < count; ++j) m.joints.push_back({"joint " + std::to_string(j), j - 1, origin});
}

}  // namespace

UnitLength random_unit_length(std::mt19937& random) {
  return one_of({UnitLength::as_doubles, UnitLength::as_floats, UnitLength::anything, UnitLength::longest, UnitLength::shortest},
                random);
}

Quaternion<double> with_length(const Quaternion<double>& unit, UnitLength length, std::mt19937& random) {
  switch (length) {
    case UnitLength::as_floats: return unit.cast<float>().cast<double>();
    case UnitLength::anything: return unit * std::sqrt(1 + std::uniform_real_distribution<double>(-edge, edge)(random));
    case UnitLength::longest: return unit * std::sqrt(1 + edge);
    case UnitLength::shortest: return unit * std::sqrt(1 - edge);
    default: return unit;
  }
}

Pose with_lengths(Pose pose, UnitLength length, std::mt19937& random) {
  for (auto& joint : pose) joint.rotation = with_length(joint.rotation, length, random);
  return pose;
}

RigidTransform<double> accepted_placement(std::mt19937& random, double far) {
  std::normal_distribution<double> normal;
  const Quaternion<double> rotation = with_length(random_turn(random), random_unit_length(random), random);
  if (random() % 3 == 0) return {rotation, {0, 0, 0}};
  return {rotation, Point3(normal(random), normal(random), normal(random)) * far};
}

Skinning drawn_skinning() {
  return *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::hejl, Skinning::dual_quaternion);
}
Skinning random_skinning(std::mt19937& random) { return one_of(all_skinnings, random); }

Attained attained(std::mt19937& random, const AttainedOptions& options) {
  std::uniform_real_distribution<double> u(-1, 1);
  const int joints = options.joints ? options.joints : one_of({1, 2, 3, 4, 5, 6, 8, 9, 16, 17, 90}, random);
  const double radius = options.unit * one_of({1.0, 1 - 0x1p-40, 1.9, 0.1 + 0.9 * std::abs(u(random))}, random);
  const Point3 center =
      random() % 2 ? Point3(0, 0, 0) : Point3(u(random), u(random), u(random)) * options.unit * one_of({1.0, 10.0, 1e4}, random);
  Attained out{.mesh = {}, .pose = {}, .placement = accepted_placement(random, options.far), .size = 0, .what = ""};
  SkinnedMesh& m = out.mesh;
  m.name = "octahedron";
  add_joints(m, joints, center);
  const bool are_weights_one = random() % 2;  // of all vertices
  std::vector<std::pair<int, double>> weights;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {1, -1}) {
      if (!are_weights_one) weights.clear();
      for (int j = static_cast<int>(weights.size()); j < joints; ++j)
        weights.emplace_back(j, random() % 2 ? 1 : 0.01 + std::abs(u(random)));
      m.vertices.push_back(center + Point3::Unit(axis) * (sign * radius));
      m.influences.emplace_back();
      for (const auto& [joint, weight] : quantize_weights(weights)) m.influences.back().push_back({joint, weight});
    }
  for (const int a : {0, 1})
    for (const int b : {2, 3})
      for (const int c : {4, 5}) m.triangles.push_back({a, b, c});
  const RigidTransform<double> turn{with_length(random_turn(random), random_unit_length(random), random),
                                    Point3(u(random), u(random), u(random)) * (random() % 2 ? 0 : options.unit)};
  out.pose.assign(joints, turn);
  out.size = radius + 2 * upper_norm(center) + upper_norm(turn.translation);
  out.what = std::to_string(joints) + " joints, radius " + std::to_string(radius) + ", squared lengths 1 + " +
             std::to_string(1e6 * (squared_norm(turn.rotation) - 1)) + "e-6 and 1 + " +
             std::to_string(1e6 * (squared_norm(out.placement.rotation) - 1)) + "e-6";
  return out;
}

SkinnedMesh needle(int axis, int sign, double length, int joints) {
  SkinnedMesh m;
  m.name = "needle";
  const Point3 away = Point3::Unit(axis) * sign, aside = Point3::Unit((axis + 1) % 3);
  add_joints(m, joints, away * length);
  m.vertices = {{0, 0, 0}, away * (2 * length) + aside * (length / 1024), away * (2 * length) - aside * (length / 1024)};
  m.triangles = {{0, 1, 2}};
  std::vector<std::pair<int, double>> weights;
  for (int j = 0; j < joints; ++j) weights.emplace_back(j, 1);
  for (int v = 0; v < 3; ++v) {
    m.influences.emplace_back();
    for (const auto& [joint, weight] : quantize_weights(weights)) m.influences.back().push_back({joint, weight});
  }
  return m;
}

}  // namespace proptests::gen
