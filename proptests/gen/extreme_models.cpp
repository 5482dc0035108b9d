// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/extreme_models.hpp"

#include <random>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"

namespace proptests::gen {

using namespace refitlab;

namespace {

SkinnedMesh tube(int joints) { return make_mesh({MeshKind::tube, 6, 4, joints, 5}); }

// Makes a strip of so many vertices. weights_of gives vertex v its joints and weights.
template <class Position, class WeightsOf>
SkinnedMesh strip(int vertices, int joints, const Position& position, const WeightsOf& weights_of) {
  SkinnedMesh m{.name = "strip", .vertices = {}, .triangles = {}, .joints = {}, .influences = {}};
  for (int j = 0; j < joints; ++j) m.joints.push_back({"joint " + std::to_string(j), j - 1, {0, 0, 0.01 * j}});
  for (int v = 0; v < vertices; ++v) {
    m.vertices.push_back(position(v));
    m.influences.emplace_back();
    for (const auto& [joint, weight] : quantize_weights(weights_of(v))) m.influences.back().push_back({joint, weight});
    if (v >= 2) m.triangles.push_back({v - 2, v - 1, v});
  }
  validate(m);
  return m;
}

using Weights = std::vector<std::pair<int, double>>;

SkinnedMesh thousand_joints() {
  return strip(
      700, 1000, [](int v) { return Point3(0.2 * (v % 2), 0.1 * (v % 3), 0.014 * v); },
      [](int v) {
        const int joint = v * 997 / 700;
        return Weights{{joint, 0.5}, {joint + 1, 0.3}, {joint + 2, 0.2}};
      });
}

SkinnedMesh sixty_four_influences() {
  return strip(
      40, 64, [](int v) { return Point3(0.2 * (v % 2), 0.1 * (v % 3), 0.016 * v); },
      [](int v) {
        Weights weights;
        for (int j = 0; j < 64; ++j) weights.emplace_back(j, 1 + (v * 7 + j * 13) % 11);
        return weights;
      });
}

SkinnedMesh one_of_many_joints() {
  return strip(
      30, 5, [](int v) { return Point3(0.2 * (v % 2), 0.1 * (v % 3), 0.016 * v); },
      [](int) {
        return Weights{{2, 1}};
      });
}

SkinnedMesh on_a_line() {
  return strip(
      30, 3, [](int v) { return Point3(0.1 * (v % 7), 0.1 * (v % 7), 0.1 * (v % 7)); },
      [](int v) {
        return Weights{{v % 3, 0.5}, {(v + 1) % 3, 0.5}};
      });
}

}  // namespace

SkinnedMesh scaled(SkinnedMesh model, double factor) {
  for (Point3& v : model.vertices) v *= factor;
  for (Joint& j : model.joints) j.origin *= factor;
  return model;
}

Pose scaled(Pose pose, double factor) {
  for (auto& c : pose) c.translation *= factor;
  return pose;
}

std::vector<ExtremeModel> extreme_models() {
  std::mt19937 random(2006);
  std::vector<ExtremeModel> out;
  const auto add = [&](const char* what, SkinnedMesh model, double size) {
    Pose pose = scaled(random_pose(model, random), size);
    out.push_back({what, std::move(model), std::move(pose)});
  };
  add("coordinates of 1e30", scaled(tube(3), 1e30), 1e30);
  add("coordinates of 1e-30", scaled(tube(3), 1e-30), 1e-30);
  add("coordinates of 1e-79, whose fourth powers underflow", scaled(tube(3), 1e-79), 1e-79);
  add("coordinates of 1e-120", scaled(tube(3), 1e-120), 1e-120);
  add("coordinates of 1e-160, whose squares underflow", scaled(tube(3), 1e-160), 1e-160);
  add("coordinates of 1e-310, denormals", scaled(tube(3), 1e-310), 1e-310);
  add("coordinates of 1e39, the largest", scaled(tube(3), 1e39), 1e39);
  add("coordinates of 1e-30, moved by 1", scaled(tube(3), 1e-30), 1);
  add("coordinates of 1, moved by 1e30", tube(3), 1e30);
  SkinnedMesh far_vertex = tube(3), close_vertices = tube(3);
  far_vertex.vertices[0] = {1e30, 0, 0};
  for (std::size_t v = 0; v < 12; ++v) close_vertices.vertices[v] *= 1e-30;
  add("one vertex at 1e30", std::move(far_vertex), 1);
  add("half of the vertices within 1e-30", std::move(close_vertices), 1);
  add("1000 joints", thousand_joints(), 0.1);
  add("64 influences of each vertex", sixty_four_influences(), 0.1);
  add("all weights on one joint of five", one_of_many_joints(), 1);
  add("all vertices in one point", make_mesh({MeshKind::one_point, 4, 4, 3, 5}), 1);
  add("all vertices at 0", scaled(make_mesh({MeshKind::one_point, 4, 4, 3, 5}), 0), 0);
  add("all vertices on one line", on_a_line(), 1);
  return out;
}

}  // namespace proptests::gen
