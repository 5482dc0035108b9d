// SPDX-License-Identifier: GPL-3.0-or-later
// Refits one of the bounding spheres of a bent arm, which must hold all of its vertices. Exits with 1 if one is outside. Writes
// the baked arm into two files that it is given: by itself, and in a glTF file as `refitlab bake` does.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/runtime/tree/baked_file.hpp"
#include "algorithms/runtime/tree/character_file.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"
#include "lemmas/exact/exact.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

// These properties come with the package and must hold for any target that a project is compiled for: its types are laid out as
// the library's, and a square is rounded before it is added to.
static_assert(alignof(refitlab::RigidTransform<double>) <= 16);
static bool products_are_rounded() {
  const volatile double x = 1 + 0x1p-30, minus_rounded_square = -(1 + 0x1p-29);
  return x * x + minus_rounded_square == 0;
}

// Makes an arm of two bones along x, in metres: rings of vertices, whose weights pass from the one joint to the other at the
// elbow.
static refitlab::SkinnedMesh make_arm() {
  using namespace refitlab;
  constexpr int rings = 40, sides = 12;
  constexpr double length = 1, radius = 0.15;
  SkinnedMesh arm{.name = "arm", .vertices = {}, .triangles = {}, .joints = {}, .influences = {}};
  arm.joints = {{"shoulder", -1, Point3::Zero()}, {"elbow", 0, {length / 2, 0, 0}}};
  for (int ring = 0; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) {
      const double along = double(ring) / (rings - 1), angle = 6.283185307179586 * side / sides;
      const double forearm = std::min(std::max((along - 0.4) / 0.2, 0.0), 1.0);
      arm.vertices.push_back({length * along, radius * std::cos(angle), radius * std::sin(angle)});
      arm.influences.emplace_back();
      for (const auto& [joint, weight] : quantize_weights({{0, 1 - forearm}, {1, forearm}}))
        arm.influences.back().push_back({joint, weight});
      const int a = ring * sides + side, b = ring * sides + (side + 1) % sides;
      if (ring + 1 < rings) arm.triangles.push_back({a, b, a + sides}), arm.triangles.push_back({b, b + sides, a + sides});
    }
  return arm;
}

int main(int, char** argv) {
  using namespace refitlab;
  const Character arm = bake(make_arm());
  std::ofstream(argv[1], std::ios::binary) << bytes_of(arm);
  ClusterBounds clusters;
  clusters.clips = {{"", 0, {}}};  // This is the rest pose.
  const std::string chunk = chunk_of({Skinning::spherical, RotationBlend::slerp, arm, clusters});
  std::ofstream(argv[2], std::ios::binary) << glb_of({{json_chunk, R"({"asset":{"version":"2.0"}})"}, {refitlab_chunk, chunk}},
                                                     argv[2]);
  const RefitVariant& variant = default_variant(Skinning::spherical);
  // The forearm is turned by a quarter about the elbow, which stays where it is.
  const double half = std::sqrt(0.5), elbow = arm.mesh.joints[1].origin[0];
  const Pose pose{RigidTransform<double>{}, {{half, 0, 0, half}, {elbow, -elbow, 0}}};
  const SkinningPalette<double> palette = make_skinning_palette(arm.mesh, arm.sets, pose, variant.skinning);
  const int node = arm.tree.nodes[0].first_child;
  const Ball3<double> ball = variant.refit(arm.refit_node(node, palette, variant.pieces));

  const std::vector<Point3> deformed = skin(arm.mesh, arm.sets, palette, variant.skinning);
  int outside = 0;
  for (const int v : arm.vertices[node]) outside += (deformed[v] - ball.center).norm() > ball.radius * (1 + 1e-12);
  std::printf("%s: radius %.3f, %zu vertices, %d outside\n", variant.name.c_str(), ball.radius, arm.vertices[node].size(),
              outside);
  if (outside || arm.vertices[node].empty() || !(ball.radius > 0)) return 1;
  if (!products_are_rounded()) return std::puts("compiled with fused multiply-add"), 1;

  // In exact numbers, Lemma 5's printed ball of half a sphere and more misses the apex, and the repaired one does not.
  const Cap<Rational, 2> cap{{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, Rational(-3, 5)};
  const bool refuted = cap_ball_encloses_printed(cap, cap.apex) == Verdict::fails;
  return refuted && cap_ball_encloses_repaired(cap, cap.apex) == Verdict::holds ? 0 : 1;
}
