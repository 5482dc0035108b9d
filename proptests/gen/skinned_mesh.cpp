// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/skinned_mesh.hpp"

#include <random>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "proptests/gen/any_place.hpp"

namespace proptests::gen {

using namespace refitlab;

rc::Gen<MeshPlan> mesh_plan() {
  return rc::gen::apply(
      [](int kind, int rings, int sides, int joints, unsigned seed) {
        return MeshPlan{kind < mesh_kind_count ? static_cast<MeshKind>(kind) : MeshKind::tube, rings, sides, joints, seed};
      },
      between<int>(0, mesh_kind_count + 5), between<int>(2, 13), between<int>(3, 9), between<int>(1, 5),
      rc::gen::arbitrary<unsigned>());
}

MeshPlan classified_plan() {
  const MeshPlan plan = *mesh_plan();
  RC_CLASSIFY(is_degenerate(plan), "degenerate");
  return plan;
}

SkinnedMesh make_mesh(const MeshPlan& plan) {
  std::mt19937 random(plan.seed);
  std::uniform_real_distribution<double> noise(-0.3, 0.3);
  const int joints = plan.kind == MeshKind::many_influences ? 8 : plan.joints;
  SkinnedMesh m{.name = "tube", .vertices = {}, .triangles = {}, .joints = {}, .influences = {}};
  for (int j = 0; j < joints; ++j) m.joints.push_back({"joint " + std::to_string(j), j - 1, {0, 0, 1.0 * j}});
  for (int ring = 0; ring < plan.rings; ++ring)
    for (int side = 0; side < plan.sides; ++side) {
      const double angle = 6.283185307179586 * side / plan.sides;
      Point3 v(std::cos(angle) + noise(random), std::sin(angle) + noise(random), 0.5 * ring + noise(random));
      if (plan.kind == MeshKind::flat) v[0] = 1;
      if (plan.kind == MeshKind::one_point) v = {1, 2, 3};
      m.vertices.push_back(v);
      std::vector<std::pair<int, double>> weights{{static_cast<int>(random() % joints), 1}};
      const int more = plan.kind == MeshKind::many_influences ? joints : static_cast<int>(random() % joints);
      for (int i = 0; i < more; ++i) weights.emplace_back((ring + i) % joints, 0.1 * static_cast<double>(random() % 5));
      m.influences.emplace_back();
      for (const auto& [joint, weight] : quantize_weights(weights)) m.influences.back().push_back({joint, weight});
    }
  for (int ring = 0; ring + 1 < plan.rings; ++ring)
    for (int side = 0; side < plan.sides; ++side) {
      const int a = ring * plan.sides + side, b = ring * plan.sides + (side + 1) % plan.sides;
      m.triangles.push_back({a, b, a + plan.sides});
      m.triangles.push_back({b, b + plan.sides, a + plan.sides});
    }
  if (plan.kind == MeshKind::one_triangle) m.triangles.resize(1);
  if (plan.kind == MeshKind::repeated_triangles)
    for (std::size_t t = 1; t < m.triangles.size(); t += 2) m.triangles[t] = m.triangles[t - 1];
  validate(m);
  return m;
}

void showValue(const MeshPlan& plan, std::ostream& out) {
  out << "mesh of kind " << static_cast<int>(plan.kind) << ", " << plan.rings << " rings of " << plan.sides << ", " << plan.joints
      << " joints, seed " << plan.seed;
}

}  // namespace proptests::gen
