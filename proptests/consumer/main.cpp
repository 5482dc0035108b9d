// SPDX-License-Identifier: GPL-3.0-or-later
// A twisted man, one of whose bounding spheres is refitted; all of its vertices must be inside. Exits with 1 if one is not. Writes
// the baked man into a file that it is given.
#include <cstdio>
#include <fstream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/model/procedural/procedural.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/runtime/tree/character_file.hpp"
#include "lemmas/exact/exact.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

// What comes with the package and must hold for any target that a project is compiled for: its types are laid out as the
// library's, and a square is rounded before it is added to.
static_assert(alignof(refitlab::RigidTransform<double>) <= 16);
static bool products_are_rounded() {
  const volatile double x = 1 + 0x1p-30, minus_rounded_square = -(1 + 0x1p-29);
  return x * x + minus_rounded_square == 0;
}

int main(int, char** argv) {
  using namespace refitlab;
  const auto man = bake(make_man(1034));
  std::ofstream(argv[1], std::ios::binary) << bytes_of(man);
  const RefitVariant& variant = default_variant(Skinning::spherical);
  const Pose pose = man.clips[1].sample(man.clips[1].duration);
  const SkinningPalette<double> palette = make_skinning_palette(man.mesh, man.sets, pose, variant.skinning);
  const int node = man.tree.nodes[0].first_child;
  const Ball3<double> ball = variant.refit(man.refit_node(node, palette, variant.pieces));

  const std::vector<Point3> deformed = skin(man.mesh, man.sets, palette, variant.skinning);
  int outside = 0;
  for (const int v : man.vertices[node]) outside += (deformed[v] - ball.center).norm() > ball.radius * (1 + 1e-12);
  std::printf("%s: radius %.3f, %zu vertices, %d outside\n", variant.name.c_str(), ball.radius, man.vertices[node].size(),
              outside);
  if (outside || man.vertices[node].empty() || !(ball.radius > 0)) return 1;
  if (!products_are_rounded()) return std::puts("compiled with fused multiply-add"), 1;

  // Lemma 5 in exact numbers: the printed ball of half a sphere and more misses the apex, the repaired one does not.
  const Cap<Rational, 2> cap{{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, Rational(-3, 5)};
  const bool refuted = cap_ball_encloses_printed(cap, cap.apex) == Verdict::fails;
  return refuted && cap_ball_encloses_repaired(cap, cap.apex) == Verdict::holds ? 0 : 1;
}
