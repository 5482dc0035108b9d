// SPDX-License-Identifier: GPL-3.0-or-later
// Runs every kernel on every target that this program has and this processor runs, on a walking man. What is rounded as the
// scalars are must be bit-identical to them, and what bounds must hold all vertices. Exits with 1 where that fails, or where a
// target that the processor runs was not compiled. It is for the compilers that the test suites are not built by.
#include <cstdio>
#include <cstring>

#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "algorithms/runtime/collide/collide.hpp"
#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"

using namespace refitlab;

namespace {

struct Failures {
  Target target;
  int count = 0;
  void check(bool holds, const char* what) {
    if (!holds) std::printf("%s: %s\n", name_of(target), what), ++count;
  }
};

bool same(std::span<const Point3> a, std::span<const Point3> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}
bool holds(const Box<double>& box, const Point3& p) {
  return (box.low.array() <= p.array()).all() && (p.array() <= box.high.array()).all();
}

void check_target(const Character& c, const Pose& pose, Skinning skinning, Failures& failures) {
  const Target target = failures.target;
  const SkinningPalette<double> palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
  const std::vector<Point3> vertices = skin(c.mesh, c.sets, palette, skinning);

  SkinningPalette<double> packed_pose;
  PalettePacks(c.mesh, c.sets, skinning).make(pose, packed_pose, target);
  failures.check(same(skin(c.mesh, c.sets, packed_pose, skinning), vertices), "a palette made in packs is another");
  std::vector<Point3> skinned(vertices.size());
  PackedVertices(c.mesh, c.sets).skin_all(palette, skinning, skinned, target);
  failures.check(same(skinned, vertices), "vertices skinned in packs are others");

  const Box<double> reach = MotionBound(c.mesh, c.sets, skinning).box(pose, {}, target);
  for (const Point3& v : vertices) failures.check(holds(reach, v), "a vertex is beyond the reach");

  std::vector<int> nodes(c.tree.nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = static_cast<int>(n);
  JointFloats joints(c.sets);
  joints.fill(palette, skinning);
  std::vector<FlippedBox> boxes(nodes.size());
  bound_boxes(make_box_pieces(c, nodes), skinning, joints, palette, identity_quaternion<double>(), boxes, target);
  for (const int n : nodes)
    for (const int v : c.vertices[n]) failures.check(holds(boxes[n].box(), vertices[v]), "a vertex is outside its node's box");

  if (skinning == Skinning::dual_quaternion) return;
  BatchRefit batch(c.tree, c.sets);
  const PackedBalls& balls = skinning == Skinning::linear ? batch.linear(palette, target) : batch.spherical(palette, target);
  for (const int n : nodes)
    for (const int v : c.vertices[n]) {
      const double distance = (balls[n].center.cast<double>() - vertices[v]).norm();
      failures.check(distance <= balls[n].radius, "a vertex is outside its node's ball");
    }
}

// Says whether pairs agree. The queries take the widest target: pieces of nodes, clusters, triangles.
bool pairs_agree(const Character& c, const Pose& pose, Skinning skinning) {
  const ClusterTree tree(c);
  ClusterBody first(tree, skinning), second(tree, skinning);
  const RigidTransform<double> beside{identity_quaternion<double>(), Point3(0.3, 0.1, 0.05)};
  first.begin(pose, {}), second.begin(pose, beside);
  QueryCounts counts;
  auto found = collide(first, second, Query::full, counts);
  std::vector<TrianglePoints> moved, own;
  const auto vertices = skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, pose, skinning), skinning);
  for (const Triangle& t : c.mesh.triangles) {
    own.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
    moved.push_back({apply(beside, own.back()[0]), apply(beside, own.back()[1]), apply(beside, own.back()[2])});
  }
  std::size_t touching = 0;
  for (const TrianglePoints& a : own)
    for (const TrianglePoints& b : moved) touching += triangles_meet(a, b);
  return found.size() == touching && touching > 0;
}

}  // namespace

int main() {
  const auto man = bake_animated(make_man(1034));
  const Pose pose = man.clips[0].sample(0.3 * man.clips[0].duration);
  int failed = 0;
  for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
    for (const Target target : available_targets()) {
      Failures failures{target};
      check_target(man, pose, skinning, failures);
      failed += failures.count;
    }
    if (!pairs_agree(man, pose, skinning)) std::puts("touching pairs are missed or made up"), ++failed;
  }
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && best_target() == Target::baseline) std::puts("there are no wide kernels"), ++failed;
#endif
  std::printf("%zu targets up to %s, %d failures\n", available_targets().size(), name_of(best_target()), failed);
  return failed ? 1 : 0;
}
