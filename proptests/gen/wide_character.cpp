// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/wide_character.hpp"

#include <cmath>
#include <ostream>
#include <random>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "proptests/gen/any_place.hpp"

namespace proptests::gen {

using namespace refitlab;

rc::Gen<WidePlan> wide_plan(int least_exponent, int greatest_exponent) {
  return rc::gen::exec([=] {
    WidePlan plan{};
    plan.joints = *rc::gen::element(2, 3, 4, 5, 8, 17, 90, 90, 1);
    plan.influences =
        *rc::gen::element(plan.joints, plan.joints, std::min(plan.joints, *between(2, 5)), std::min(plan.joints, 5), 1);
    plan.vertices = *between(3, 17);
    const int any = *between(least_exponent, greatest_exponent + 1);
    plan.exponent = *rc::gen::element(0, any, any, least_exponent, greatest_exponent);
    plan.lengths = *between(0, 3);
    plan.turn = *rc::gen::element(0.3, 1.0, 1e-4, 10.0, 0.0);
    plan.seed = *rc::gen::arbitrary<unsigned>();
    return plan;
  });
}

SkinnedMesh wide_model(const WidePlan& plan) {
  std::mt19937 random(plan.seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    return Point3(std::ldexp(x, plan.exponent), std::ldexp(y, plan.exponent), std::ldexp(z, plan.exponent));
  };
  SkinnedMesh m;
  m.name = "wide";
  for (int j = 0; j < plan.joints; ++j) m.joints.push_back({"joint " + std::to_string(j), j - 1, point()});
  for (int v = 0; v < plan.vertices; ++v) {
    m.vertices.push_back(point());
    std::vector<std::pair<int, double>> weights;
    const int first = random() % 3 == 0 ? 0 : static_cast<int>(random() % static_cast<unsigned>(plan.joints));
    for (int i = 0; i < plan.influences; ++i)
      weights.emplace_back((first + i) % plan.joints, std::ldexp(1.5 + uniform(random), -static_cast<int>(random() % 12)));
    m.influences.emplace_back();
    for (const auto& [joint, weight] : quantize_weights(weights)) m.influences.back().push_back({joint, weight});
  }
  for (int v = 0; v + 2 < plan.vertices; ++v) m.triangles.push_back({v, v + 1, v + 2});
  validate(m);
  return m;
}

Pose wide_pose(const WidePlan& plan, const SkinnedMesh& model) {
  // The square of such a length differs from 1 by a little less than 1e-6.
  constexpr double end = 0.4999e-6;
  std::mt19937 random(plan.seed + 1);
  std::normal_distribution<double> normal;
  const Quaternion<double> first =
      Quaternion<double>(normal(random), normal(random), normal(random), normal(random)).normalized();
  Pose pose = reference_pose(model);
  for (auto& c : pose) {
    const double x = normal(random), y = normal(random), z = normal(random);
    c.rotation = multiply(first, Quaternion<double>(1, x * plan.turn, y * plan.turn, z * plan.turn)).normalized();
    if (plan.lengths == 1) c.rotation = c.rotation.cast<float>().cast<double>().eval();
    if (plan.lengths == 2) c.rotation *= random() % 2 == 0 ? 1 + end : 1 - end;
    if (random() % 2 == 0) c.rotation = -c.rotation;
    const double scale = std::ldexp(1, plan.exponent);
    c.translation = Point3(normal(random), normal(random), normal(random)) * scale;
  }
  return pose;
}

void showValue(const WidePlan& plan, std::ostream& out) {
  out << plan.joints << " joints, " << plan.influences << " influences of each of " << plan.vertices << " vertices, lengths of 2^"
      << plan.exponent << ", quaternions of kind " << plan.lengths << ", turns of " << plan.turn << ", seed " << plan.seed;
}

}  // namespace proptests::gen
