// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/cluster_collide.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/farthest_placement.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/placed_box.hpp"
#include "proptests/oracles/placed_vertices.hpp"

namespace proptests::suite_cluster_collide {
namespace {

using namespace refitlab;
using oracle::sorted;

ClusterOptions drawn_options() {
  return {.most_triangles = *rc::gen::element(1, 3, 10, 25, most_cluster_triangles),
          .most_children = *rc::gen::element(2, 3, 9, 32)};
}

// Counts pairs of triangles whose boxes meet. So many come to the test of triangles, whatever bounded them before.
long meeting_boxes(const oracle::Posed& a, const oracle::Posed& b, Skinning skinning) {
  const auto boxes_of = [&](const oracle::Posed& posed) {
    const auto points = posed.vertices(skinning);
    std::vector<std::array<Point3, 2>> boxes;
    for (const Triangle& t : posed.character.mesh.triangles)
      boxes.push_back({points[t[0]].cwiseMin(points[t[1]]).cwiseMin(points[t[2]]),
                       points[t[0]].cwiseMax(points[t[1]]).cwiseMax(points[t[2]])});
    return boxes;
  };
  long count = 0;
  const auto first = boxes_of(a), second = boxes_of(b);
  for (const auto& p : first)
    for (const auto& q : second) count += (p[0].array() <= q[1].array()).all() && (q[0].array() <= p[1].array()).all();
  return count;
}

int triangles_below(const ClusterTree& tree, const WideNodeChild& child) {
  int count = 0;
  if (child.wide_node >= 0)
    for (int i = 0; i < tree.wide_nodes()[child.wide_node].child_count; ++i)
      count += triangles_below(tree, tree.child(child.wide_node, i));
  else count = tree.clusters()[child.cluster].triangle_count;
  return count;
}

int first_triangle(const ClusterTree& tree, WideNodeChild child) {
  while (child.wide_node >= 0) child = tree.child(child.wide_node, 0);
  return tree.triangles(child.cluster)[0];
}

// Makes triangles beside each other, each of three vertices of its own, in the plane z = 0. joints_of gives the two joints of a
// vertex, or the same one twice.
template <class JointsOf>
SkinnedMesh row_of_triangles(int count, int joints, const JointsOf& joints_of) {
  SkinnedMesh m;
  m.name = "row";
  for (int j = 0; j < joints; ++j) m.joints.push_back({"joint " + std::to_string(j), j - 1, {0, 0, 0}});
  for (int t = 0; t < count; ++t) {
    const Point3 at(t % 200, t / 200, 0);
    for (const Point3& vertex : {Point3(0, 0, 0), Point3(0.4, 0, 0), Point3(0, 0.4, 0)}) {
      const auto [i, j] = joints_of(static_cast<int>(m.vertices.size()));
      m.vertices.push_back(at + vertex);
      if (i == j) m.influences.push_back({{i, 1.0}});
      else m.influences.push_back({{i, 0.5}, {j, 0.5}});
    }
    m.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  validate(m);
  return m;
}

RigidTransform<double> moved(double x, double y = 0, double z = 0) { return {identity_quaternion<double>(), {x, y, z}}; }

// Holds two bodies of one man, and his walk.
struct TwoMen {
  const AnimatedCharacter man = bake_animated(make_man());
  const ClusterTree tree{man};
  const Clip& walk = man.clips[0];
  ClusterBody a{tree, Skinning::spherical}, b{tree, Skinning::spherical};
  Pose at(double share) const { return walk.sample(share * walk.duration); }
};

// Counts which of some triangles of a row are not found by a triangle that is put upon them, or are found with others.
long lost_of_row(const ClusterTree& row, const std::vector<int>& triangles) {
  const auto stamp = bake(row_of_triangles(1, 1, [](int) { return std::pair(0, 0); }));
  const ClusterTree stamp_tree(stamp);
  ClusterBody first(row, Skinning::linear), second(stamp_tree, Skinning::linear);
  first.begin(reference_pose(row.character().mesh), {});
  long lost = 0;
  for (const int t : triangles) {
    second.begin(Pose(1), {identity_quaternion<double>(), row.character().mesh.vertices[3 * t]});
    QueryCounts counts;
    lost += collide(first, second, Query::full, counts) != std::vector<TrianglePair>{{t, 0}};
    lost += collide(second, first, Query::full, counts) != std::vector<TrianglePair>{{0, t}};
  }
  return lost;
}

void pairs_are_those_of_testing_all(Suite& t) {
  t.holds("finds the pairs that testing all pairs finds, in every skinning, for clusters and wide_nodes of any size",
          {.number_type = "double", .cases = 200, .degenerate_at_least = 0.3}, [] {
            const auto plan_a = *gen::mesh_plan(), plan_b = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan_a) || gen::is_degenerate(plan_b), "degenerate");
            // It has units of its own, which are not converted.
            SkinnedMesh other = gen::make_mesh(plan_b);
            const double unit = *rc::gen::element(1.0, 1.0, 0.01, 100.0);
            for (Point3& v : other.vertices) v *= unit;
            for (auto& joint : other.joints) joint.origin *= unit;
            const Character a = bake(gen::make_mesh(plan_a), {.triangles_per_leaf = *rc::gen::element(1, 40)}),
                            b = bake(std::move(other));
            const ClusterTree tree_a(a, drawn_options()), tree_b(b, drawn_options());
            const Skinning skinning = gen::drawn_skinning();
            ClusterBody first(tree_a, skinning), second(tree_b, skinning);
            PairMemory memory;
            std::mt19937 random(plan_a.seed);
            std::normal_distribution<double> normal;
            for (int frame = 0; frame < 3; ++frame) {
              const auto length = gen::random_unit_length(random);
              const Pose pose_a = gen::with_lengths(gen::random_pose(a.mesh, random), length, random),
                         pose_b = gen::with_lengths(gen::random_pose(b.mesh, random), length, random);
              const double apart = frame == 2 ? 3 : 0.5;
              const RigidTransform<double> at_a{gen::random_rotation(random, 1), {normal(random), 0, 0}},
                  at_b{gen::random_rotation(random, 1), at_a.translation + Point3(normal(random), normal(random), 0) * apart};
              first.begin(pose_a, at_a), second.begin(pose_b, at_b);
              const auto expected = oracle::all_pairs({a, pose_a, at_a}, {b, pose_b, at_b}, skinning);
              QueryCounts counts;
              const auto one = collide(first, second, Query::yes_no, counts);
              RC_ASSERT(one.size() == (expected.empty() ? 0u : 1u));
              if (!one.empty()) RC_ASSERT(std::find(expected.begin(), expected.end(), one[0]) != expected.end());
              const auto again = collide(first, second, Query::yes_no, counts, &memory);
              RC_ASSERT(again.size() == one.size());
              if (!one.empty()) RC_ASSERT(std::find(expected.begin(), expected.end(), again[0]) != expected.end());
              QueryCounts of_all;
              RC_ASSERT(sorted(collide(first, second, Query::full, of_all, &memory)) == expected);
              RC_ASSERT(of_all.triangle_tests >= meeting_boxes({a, pose_a, at_a}, {b, pose_b, at_b}, skinning));
              RC_TAG(expected.empty() ? "apart" : "in contact");
            }
          });
  t.holds("a character against itself in another place, by two bodies that share a tree",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const auto c = bake(gen::make_mesh(plan));
            const ClusterTree tree(c, drawn_options());
            const Skinning skinning = gen::drawn_skinning();
            std::mt19937 random(plan.seed);
            const Pose pose = gen::random_pose(c.mesh, random);
            const RigidTransform<double> at{gen::random_rotation(random, 1), {0.3, 0, 0.1}}, here{};
            ClusterBody first(tree, skinning), second(tree, skinning);
            first.begin(pose, here), second.begin(pose, at);
            QueryCounts counts;
            RC_ASSERT(sorted(collide(first, second, Query::full, counts)) ==
                      oracle::all_pairs({c, pose, here}, {c, pose, at}, skinning));
          });
}

// Draws a plan of a mesh of few triangles, where all pairs of them are hard to decide.
gen::MeshPlan small_plan() {
  gen::MeshPlan plan = *gen::mesh_plan();
  plan.rings = std::min(plan.rings, 4), plan.sides = std::min(plan.sides, 4);
  return plan;
}

// Checks one memory for the pairs of three bodies, of two trees, in either order and in frames drawn anew, as no caller should
// use it. What it remembers belongs to other bodies, and no pair is lost or found for it.
void check_memory_of_other_bodies() {
  const gen::MeshPlan plan_a = small_plan(), plan_b = small_plan();
  RC_CLASSIFY(gen::is_degenerate(plan_a) || gen::is_degenerate(plan_b), "degenerate");
  const Character a = bake(gen::make_mesh(plan_a)), b = bake(gen::make_mesh(plan_b));
  const ClusterTree tree_a(a, drawn_options()), tree_b(b, drawn_options());
  const Skinning skinning = gen::drawn_skinning();
  ClusterBody one(tree_a, skinning), two(tree_a, skinning), three(tree_b, skinning);
  ClusterBody* const bodies[] = {&one, &two, &three};
  const Character* const characters[] = {&a, &a, &b};
  PairMemory memory;
  std::mt19937 random(plan_a.seed);
  std::normal_distribution<double> normal;
  for (int frame = 0; frame < 4; ++frame) {
    Pose poses[3];
    RigidTransform<double> places[3];
    const double apart = frame == 2 ? 4 : 0.4;
    for (int i = 0; i < 3; ++i) {
      poses[i] = gen::random_pose(characters[i]->mesh, random);
      places[i] = {gen::random_rotation(random, 1), Point3(normal(random), normal(random), 0) * apart};
      bodies[i]->begin(poses[i], places[i]);
    }
    for (int query = 0; query < 8; ++query) {
      const int i = static_cast<int>(random() % 3), k = static_cast<int>((i + 1 + random() % 2) % 3);
      const auto expected =
          oracle::all_pairs({*characters[i], poses[i], places[i]}, {*characters[k], poses[k], places[k]}, skinning);
      QueryCounts counts;
      RC_ASSERT(sorted(collide(*bodies[i], *bodies[k], Query::full, counts, &memory)) == expected);
      const auto any = collide(*bodies[i], *bodies[k], Query::yes_no, counts, random() % 2 ? &memory : nullptr);
      RC_ASSERT(any.size() == (expected.empty() ? 0u : 1u));
      if (!any.empty()) RC_ASSERT(std::binary_search(expected.begin(), expected.end(), any[0]));
      RC_TAG(expected.empty() ? "apart" : "in contact");
      if (memory.are_entangled()) RC_TAG("entangled");
    }
  }
}

// Checks placements so far away that sums and differences of their coordinates overflow.
void check_placements_at_the_end_of_double() {
  const gen::MeshPlan plan = small_plan();
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  const Character c = bake(gen::make_mesh(plan));
  const ClusterTree tree(c, drawn_options());
  const Skinning skinning = gen::drawn_skinning();
  ClusterBody first(tree, skinning), second(tree, skinning);
  std::mt19937 random(plan.seed);
  const Pose pose = gen::random_pose(c.mesh, random);
  PairMemory memory;
  for (int i = 0; i < 4; ++i) {
    const RigidTransform<double> at_a = gen::farthest_placement(random);
    RigidTransform<double> at_b = gen::farthest_placement(random);
    if (i < 3) at_b.translation = at_a.translation;
    if (i == 2) at_b.translation[0] = std::nextafter(at_b.translation[0], 0);
    first.begin(pose, at_a), second.begin(pose, at_b);
    const auto expected = oracle::all_pairs({c, pose, at_a}, {c, pose, at_b}, skinning);
    QueryCounts counts;
    RC_ASSERT(sorted(collide(first, second, Query::full, counts)) == expected);
    RC_ASSERT(sorted(collide(first, second, Query::full, counts, &memory)) == expected);
    RC_ASSERT(collide(first, second, Query::yes_no, counts, &memory).empty() == expected.empty());
    RC_TAG(expected.empty() ? "apart" : "in contact");
  }
}

void memories_of_others_and_places_far_away(Suite& t) {
  t.holds("a memory that pairs of other bodies, in either order, and of another tree have used loses no pair and adds none",
          {.number_type = "double",
           .cases = 50,
           .degenerate_at_least = 0.3,
           .tags_at_least = {{"in contact", 0.3}, {"apart", 0.1}, {"entangled", 0.05}}},
          check_memory_of_other_bodies);
  t.holds(
      "pairs of bodies at the end of what doubles are, where differences of places overflow, are those of testing all",
      {.number_type = "double", .cases = 25, .degenerate_at_least = 0.3, .tags_at_least = {{"in contact", 0.3}, {"apart", 0.3}}},
      check_placements_at_the_end_of_double);
}

void a_needle_touches_where_a_bound_is_attained(Suite& t) {
  t.holds(
      "a needle that touches a body in one vertex, where a bound is attained, touches it: of 1 to 90 joints, at every "
      "scale and place, however long quaternions are",
      {.number_type = "double", .cases = 2000}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        const double unit = *rc::gen::element(1.0, 1.0, 1e-12, 1e-36, 1e-44, 1e-160, 1e-300, 1e12, 1e18, 1e33, 1e35),
                     far = *rc::gen::element(0.0, 0.0, 1.0, 1e6, 1e30, 1e300);
        const gen::Attained scene = gen::attained(random, {.unit = unit, .far = far});
        const Skinning skinning = gen::random_skinning(random);
        const auto c = bake(scene.mesh, {.triangles_per_leaf = *rc::gen::element(1, 8)});
        const auto points = oracle::Posed{c, scene.pose, scene.placement}.vertices(skinning);
        const int axis = static_cast<int>(random() % 3), sign = random() % 2 ? 1 : -1;
        Point3 tip = points[0];
        for (const Point3& p : points)
          if (sign * p[axis] > sign * tip[axis]) tip = p;
        const int joints = *rc::gen::element(1, 5, 9);
        // The length is a power of two, so that weighted parts of it add up to it.
        const double length = std::exp2(std::max(-990.0, std::round(std::log2(unit)) - *rc::gen::element(0, 30)));
        const auto needle = bake(gen::needle(axis, sign, length, joints));
        const Pose still = reference_pose(needle.mesh);
        const RigidTransform<double> at{identity_quaternion<double>(), tip};
        const ClusterTree tree(c, drawn_options()), tree_of_needle(needle);
        ClusterBody body(tree, skinning), other(tree_of_needle, Skinning::spherical);
        body.begin(scene.pose, scene.placement), other.begin(still, at);
        std::vector<TrianglePair> expected;
        const auto needle_points = oracle::Posed{needle, still, at}.vertices(Skinning::spherical);
        for (std::size_t t = 0; t < c.mesh.triangles.size(); ++t) {
          const Triangle& v = c.mesh.triangles[t];
          if (triangles_meet({points[v[0]], points[v[1]], points[v[2]]}, {needle_points[0], needle_points[1], needle_points[2]}))
            expected.push_back({static_cast<int>(t), 0});
        }
        RC_LOG() << scene.what;
        QueryCounts counts;
        RC_ASSERT(!expected.empty());
        // The wide nodes are bounded, or the clusters are skinned instead, or everything is skinned.
        const int how = *rc::gen::inRange(0, 3);
        if (how == 1) body.skin_rather(), other.skin_rather();
        if (how == 2) body.skin_all(), other.skin_all();
        RC_ASSERT(sorted(collide(body, other, Query::full, counts)) == expected);
        RC_ASSERT(collide(other, body, Query::yes_no, counts).size() == 1u);
        for (const Point3& p : points)
          RC_ASSERT(oracle::holds(body.motion_bound(), p) && oracle::holds(oracle::in_world(body, body.wide_node_box(0)), p));
        RC_ASSERT(oracle::holds(other.motion_bound(), tip) &&
                  oracle::holds(oracle::in_world(other, other.wide_node_box(0)), tip));
      });
}

void leaves_that_are_too_large(Suite& t) {
  t.example("a leaf of more vertices than 16 bits name is split, and so is one that is larger than clusters should be", {}, [] {
    const auto c = bake(row_of_triangles(30000, 1, [](int) { return std::pair(0, 0); }), {.triangles_per_leaf = 1000000});
    long lost = 0, tried = 0;
    bool ok = c.tree.nodes.size() == 1;
    for (const int most : {7, 256, most_cluster_triangles}) {
      const ClusterTree tree(c, {.most_triangles = most});
      for (const Cluster& cluster : tree.clusters())
        ok = ok && cluster.padded_vertex_count <= 1 << 16 && cluster.triangle_count <= most;
      std::vector<int> triangles;
      for (int t = 0; t < 30000; t += 997) triangles.push_back(t);
      triangles.push_back(21866), triangles.push_back(29999);
      lost += lost_of_row(tree, triangles), tried += static_cast<long>(triangles.size());
      ok = ok && triangles_below(tree, {-1, 0}) == 30000;
    }
    return Checked(ok && lost == 0, tried, std::to_string(lost) + " lost");
  });
  t.example("a cluster of the most triangles, each vertex alone in its joint-set, has places that 16 bits hold", {}, [] {
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 130; ++i)
      for (int j = i + 1; j < 130; ++j) pairs.emplace_back(i, j);
    const int count = most_cluster_triangles;
    const auto c = bake(row_of_triangles(count, 130, [&](int v) { return pairs[v]; }), {.triangles_per_leaf = count});
    const ClusterTree tree(c, {.most_triangles = most_cluster_triangles});
    const bool is_one = tree.clusters().size() == 1 && tree.clusters()[0].padded_vertex_count == 16 * 3 * count &&
                        tree.clusters()[0].padded_vertex_count <= 1 << 16;
    const long lost = lost_of_row(tree, {0, 1, count / 2, count - 2, count - 1});
    return Checked(is_one && lost == 0, 5, std::to_string(lost) + " lost");
  });
}

void clusters_and_wide_nodes(Suite& t) {
  t.holds("clusters and wide_nodes are as large as they may be and no larger, and every triangle is in one of them",
          {.cases = 100}, [] {
            const auto plan = *gen::mesh_plan();
            const int per_leaf = *rc::gen::element(1, 2, 7, 1000);
            // The tree is binary.
            const auto c = bake(gen::make_mesh(plan), {.triangles_per_leaf = per_leaf, .prune_ratio = 1e9});
            const ClusterOptions options = drawn_options();
            const ClusterTree tree(c, options);
            std::vector<int> seen;
            for (std::size_t i = 0; i < tree.clusters().size(); ++i) {
              const int count = triangles_below(tree, {static_cast<int>(i), -1});
              RC_ASSERT(count >= 1 && count <= options.most_triangles);
              const auto padded = tree.vertices().vertices(static_cast<int>(i));
              const auto places = tree.floats().places(static_cast<int>(i));
              const ClusterTriangles vertices = tree.cluster_triangles(static_cast<int>(i));
              RC_ASSERT(vertices.count == count);
              for (int t = 0; t < count; ++t) {
                const int triangle = tree.triangles(static_cast<int>(i))[t];
                seen.push_back(triangle);
                for (int k = 0; k < 3; ++k) RC_ASSERT(padded[places[vertices.vertex[k][t]]] == c.mesh.triangles[triangle][k]);
              }
            }
            std::sort(seen.begin(), seen.end());
            RC_ASSERT(seen.size() == c.mesh.triangles.size());
            for (std::size_t t = 0; t < seen.size(); ++t) RC_ASSERT(seen[t] == static_cast<int>(t));
            // This is the place of each triangle in the order of the sphere tree.
            std::vector<int> place(seen.size());
            for (std::size_t i = 0; i < place.size(); ++i) place[c.tree.triangle_order[i]] = static_cast<int>(i);
            for (int f = 0; f < static_cast<int>(tree.wide_nodes().size()); ++f) {
              const int children = tree.wide_nodes()[f].child_count;
              RC_ASSERT(children <= options.most_children);
              // The children are in the tree's order, so that neighbours are near each other.
              for (int i = 1; i < children; ++i)
                RC_ASSERT(place[first_triangle(tree, tree.child(f, i - 1))] < place[first_triangle(tree, tree.child(f, i))]);
              int least = 1 << 30, most = 0;
              bool has_wide_nodes = false;
              for (int i = 0; i < children; ++i) {
                const int count = triangles_below(tree, tree.child(f, i));
                least = std::min(least, count), most = std::max(most, count);
                has_wide_nodes = has_wide_nodes || tree.child(f, i).wide_node >= 0;
                RC_ASSERT(tree.child(f, i).wide_node < 0 || (tree.child(f, i).wide_node > f && count > options.most_triangles));
              }
              if (has_wide_nodes) RC_ASSERT(children == options.most_children);
              RC_ASSERT(most <= 4 * least + 3);  // The largest is opened first, and each part has a quarter of it.
            }
            RC_ASSERT(triangles_below(tree, {-1, 0}) == static_cast<int>(seen.size()));
          });
  t.holds("a cluster is a node of the sphere tree, or a part of a leaf that is too large", {.cases = 100}, [] {
    const auto c = bake(gen::make_mesh(*gen::mesh_plan()), {.triangles_per_leaf = *rc::gen::element(1, 2, 7, 40)});
    const ClusterOptions options = drawn_options();
    const ClusterTree tree(c, options);
    std::vector<int> place(c.mesh.triangles.size());
    for (std::size_t i = 0; i < place.size(); ++i) place[c.tree.triangle_order[i]] = static_cast<int>(i);
    for (int i = 0; i < static_cast<int>(tree.clusters().size()); ++i) {
      const int first = place[tree.triangles(i)[0]], count = triangles_below(tree, {i, -1});
      RC_ASSERT(std::any_of(c.tree.nodes.begin(), c.tree.nodes.end(), [&](const TreeNode& n) {
        const bool is_large_leaf = n.child_count == 0 && n.triangle_count > options.most_triangles;
        return is_large_leaf ? n.first_triangle <= first && first + count <= n.first_triangle + n.triangle_count
                             : n.first_triangle == first && n.triangle_count == count;
      }));
    }
  });
}

void what_is_counted(Suite& t) {
  t.example(
      "what is counted: of single triangles every box once, none where motion bounds are apart, and sums over queries", {}, [] {
        SkinnedMesh m = gen::needle(0, 1, 1, 1);
        const auto c = bake(m);
        const ClusterTree tree(c);
        ClusterBody first(tree, Skinning::spherical), second(tree, Skinning::spherical);
        const Pose still = reference_pose(c.mesh);
        const auto counts_at = [&](double x, Query query, PairMemory* memory) {
          first.begin(still, {}), second.begin(still, moved(x));
          QueryCounts counts{100, 1000};  // These counts are those of queries before.
          collide(first, second, query, counts, memory);
          return std::pair(counts.ball_tests - 100, counts.triangle_tests - 1000);
        };
        PairMemory memory;
        // The boxes that are compared are the motion bounds, the first's wide node with the whole second body, and the second's
        // wide node. The motion bounds are left out if a memory says that the bodies were near, which are then skinned whole
        // because that is less work, too. In the end no boxes are compared, but the clusters that touched.
        const std::pair<long, long> touching{3, 1}, apart{1, 0}, near{2, 1}, remembered{0, 1}, met_again{1, 1};
        bool ok = counts_at(0.5, Query::full, nullptr) == touching && counts_at(9, Query::full, nullptr) == apart;
        ok = ok && counts_at(0.5, Query::full, &memory) == touching && memory.are_near;
        ok = ok && counts_at(0.5, Query::full, &memory) == near && first.nodes_bounded() == 0;
        memory.count_query(0);
        ok = ok && counts_at(0.5, Query::full, &memory) == near && first.nodes_bounded() == 1 && first.clusters_skinned() == 1 &&
             first.vertices_skinned() == 16 && second.vertices_skinned() == 16;
        ok = ok && counts_at(0.5, Query::yes_no, &memory) == remembered && first.clusters_skinned() == 1 &&
             first.nodes_bounded() == 0;
        // The bodies are apart, and then in contact again, as the clusters that touched show once the motion bounds have been
        // compared.
        ok = ok && counts_at(9, Query::yes_no, &memory) == std::pair<long, long>(1, 0) && !memory.are_near;
        ok = ok && counts_at(0.5, Query::yes_no, &memory) == met_again && memory.are_near && first.nodes_bounded() == 0;
        return Checked(ok, 8);
      });
  t.example("a body counts the nodes that it bounds, and the clusters and vertices that it skins, each once a frame", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man);
    ClusterBody body(tree, Skinning::spherical);
    long nodes = 0, vertices = 0;
    for (const WideNode& wide_node : tree.wide_nodes()) nodes += wide_node.child_count;
    for (const Cluster& cluster : tree.clusters()) vertices += cluster.padded_vertex_count;
    const auto clusters = static_cast<long>(tree.clusters().size()), wide_nodes = static_cast<long>(tree.wide_nodes().size());
    bool ok = nodes > wide_nodes && vertices > clusters;
    for (int frame = 0; frame < 2; ++frame) {
      body.begin(man.clips[0].sample(0.1 * frame), {});
      ok = ok && body.nodes_bounded() == 0 && body.clusters_skinned() == 0 && body.vertices_skinned() == 0;
      for (int time = 0; time < 2; ++time) {
        for (int f = 0; f < static_cast<int>(wide_nodes); ++f) body.wide_node_boxes(f), body.wide_node_box(f);
        for (int c = 0; c < static_cast<int>(clusters); ++c) body.clusters().cluster(c), body.clusters().padded_vertex(c, 0);
        ok = ok && body.nodes_bounded() == nodes && body.clusters_skinned() == clusters && body.vertices_skinned() == vertices;
      }
    }
    return Checked(ok, nodes + vertices);
  });
}

bool has_only_clusters(const ClusterTree& tree, int wide_node) {
  bool has = true;
  for (int i = 0; i < tree.wide_nodes()[wide_node].child_count; ++i) has = has && tree.child(wide_node, i).cluster >= 0;
  return has;
}

void when_clusters_are_rather_skinned(Suite& t) {
  t.example("a body that rather skins does so where a wide node has only clusters, and bounds the others", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man);
    ClusterBody body(tree, Skinning::spherical);
    long wrong = 0, skinned = 0, frames = 0;
    // The choice holds for each frame by itself.
    for (const bool rather : {false, true, false, true, true, false}) {
      body.begin(man.clips[0].sample(0.1), {});
      if (rather) body.skin_rather();
      ++frames;
      for (int f = 0; f < static_cast<int>(tree.wide_nodes().size()); ++f) {
        const int children = tree.wide_nodes()[f].child_count;
        const bool is_skinned = rather && has_only_clusters(tree, f);
        const long nodes = body.nodes_bounded(), clusters = body.clusters_skinned();
        body.wide_node_box(f);
        wrong += body.nodes_bounded() - nodes != (is_skinned ? 0 : children);
        wrong += body.clusters_skinned() - clusters != (is_skinned ? children : 0);
        skinned += is_skinned;
      }
    }
    const auto count = static_cast<long>(tree.wide_nodes().size());
    return Checked(wrong == 0 && skinned > 0 && skinned < 3 * count, frames * count, std::to_string(skinned) + " are skinned");
  });
  t.example("a body of which a query has skinned several clusters in float rather skins from then on, in that frame", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man, {.most_triangles = 64, .most_children = 20});
    int leaf = static_cast<int>(tree.wide_nodes().size()) - 1;
    while (!has_only_clusters(tree, leaf)) --leaf;
    constexpr int several = ClusterBody::least_clusters_of_contact;
    long wrong = 0, frames = 0;
    for (const Skinning skinning : {Skinning::spherical, Skinning::linear}) {
      ClusterBody body(tree, skinning);
      for (const int count : {several, several - 1, several, 1}) {
        body.begin(man.clips[0].sample(0.1), {});
        for (int c = 0; c < count; ++c) body.clusters().cluster(c);
        body.tighten(0);
        body.wide_node_box(leaf);
        const bool is_skinned = skinning == Skinning::spherical && count == several;
        wrong += body.nodes_bounded() != (is_skinned ? 0 : tree.wide_nodes()[leaf].child_count), ++frames;
      }
    }
    return Checked(wrong == 0 && leaf > 0, frames);
  });
}

void what_is_skinned_cuts_bounds(Suite& t) {
  t.example(
      "where it does, the parent's bound is cut to the box around what was skinned; a query cuts that of a cluster, unless the "
      "body is "
      "shared",
      {}, [] {
        const auto man = bake_animated(make_man());
        const ClusterTree tree(man, {.most_triangles = 32, .most_children = 5});
        ClusterBody body(tree, Skinning::spherical);
        const auto box = [&](ChildPlace at) { return get_box(body.wide_node_boxes(at.wide_node), at.child); };
        const auto is_cut = [](const Box<float>& after, const Box<float>& bound, const Box<float>& to) {
          bool is = after.extent() < bound.extent();
          for (int i = 0; i < 3; ++i)
            is = is && after.low[i] == std::max(bound.low[i], to.low[i]) && after.high[i] == std::min(bound.high[i], to.high[i]);
          return is;
        };
        long wrong = 0, deep = 0, cut = 0, boxes = 0;
        for (const bool rather : {true, false, true}) {
          body.begin(man.clips[0].sample(0.1 + 0.2 * static_cast<double>(boxes % 4)), {});
          if (rather) body.skin_rather();
          for (int f = 1; f < static_cast<int>(tree.wide_nodes().size()); ++f) {  // parents come before their children
            const WideNode& wide_node = tree.wide_nodes()[f];
            const Box<float> bound = box(wide_node.place), own = body.wide_node_box(f), after = box(wide_node.place);
            const bool is_skinned = rather && has_only_clusters(tree, f);
            wrong += is_skinned ? !is_cut(after, bound, own) : after.low != bound.low || after.high != bound.high;
            cut += is_skinned, deep += is_skinned && wide_node.place.wide_node > 0, ++boxes;
          }
          for (int c = 0; c < static_cast<int>(tree.clusters().size()); ++c) {
            const Cluster& cluster = tree.clusters()[c];
            // The boxes of such a node are there already.
            if (body.clusters().is_skinned(c) && has_only_clusters(tree, cluster.place.wide_node)) continue;
            const Box<float> bound = box(cluster.place);
            body.tighten(c);
            wrong += !is_cut(box(cluster.place), bound, body.clusters().cluster(c).box), ++boxes;
          }
        }
        body.begin(man.clips[0].sample(0.1), {});
        body.share();
        for (int c = 0; c < static_cast<int>(tree.clusters().size()); ++c, ++boxes) {
          const Box<float> bound = box(tree.clusters()[c].place);
          body.clusters().cluster(c);
          body.tighten(c);
          const Box<float> after = box(tree.clusters()[c].place);
          wrong += after.low != bound.low || after.high != bound.high;
        }
        return Checked(wrong == 0 && deep > 10 && boxes > cut + 10, boxes,
                       std::to_string(wrong) + " wrong, " + std::to_string(deep));
      });
}

void what_is_skinned_spares_others(Suite& t) {
  t.example("a query skins a cluster of the second body only if its bound meets the vertices' box of a skinned one of the first",
            {}, [] {
              const auto man = bake_animated(make_man());
              const ClusterTree tree(man, {.most_triangles = 64});
              ClusterBody a(tree, Skinning::spherical), b(tree, Skinning::spherical), bounds(tree, Skinning::spherical);
              long wrong = 0, skinned = 0;
              for (int frame = 0; frame < 40; ++frame) {
                const Pose first = man.clips[0].sample(0.025 * frame), second = man.clips[0].sample(0.025 * ((frame + 13) % 40));
                const RigidTransform<double> at = moved(0.4 + 0.002 * frame, 0.1, 0.05);
                a.begin(first, {}), b.begin(second, at), bounds.begin(second, at);
                QueryCounts counts;
                collide(a, b, Query::full, counts, nullptr);
                // From so many clusters on they are skinned rather than bounded.
                if (std::max(a.clusters_skinned(), b.clusters_skinned()) >= ClusterBody::least_clusters_of_contact) continue;
                ClusterPairScratch scratch;
                const ClusterPairs pairs(a.clusters(), b.clusters(), Query::full, counts, scratch);
                const int count = static_cast<int>(tree.clusters().size());
                for (int of_b = 0; of_b < count; ++of_b) {
                  if (!b.clusters().is_skinned(of_b)) continue;
                  const ChildPlace place = tree.clusters()[of_b].place;
                  const Box<float> bound = pairs.moved(get_box(bounds.wide_node_boxes(place.wide_node), place.child));
                  bool meets = false;
                  for (int of_a = 0; of_a < count; ++of_a)
                    meets = meets || (a.clusters().is_skinned(of_a) && !are_apart(a.clusters().cluster(of_a).box, bound));
                  wrong += !meets, ++skinned;
                }
              }
              return Checked(wrong == 0 && skinned > 100, skinned, std::to_string(wrong) + " skinned for nothing");
            });
}

void boxes_once_all_is_skinned(Suite& t) {
  t.example("once all is skinned, boxes are around skinned vertices, also where they were bounds before", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man, {.most_triangles = 32, .most_children = 5});
    ClusterBody body(tree, Skinning::spherical);
    long wrong = 0, boxes = 0, smaller = 0;
    const auto same = [](const Box<float>& a, const Box<float>& b) { return a.low == b.low && a.high == b.high; };
    for (const bool rather : {false, true}) {
      body.begin(man.clips[0].sample(0.3), {});
      if (rather) body.skin_rather();
      std::vector<Box<float>> bounds;
      for (int f = 0; f < static_cast<int>(tree.wide_nodes().size()); f += 2) bounds.push_back(body.wide_node_box(f));
      const long bounded = body.nodes_bounded();
      body.skin_all();
      for (int f = 0; f < static_cast<int>(tree.wide_nodes().size()); ++f) {
        Box<float> all = Box<float>::empty();
        for (int i = 0; i < tree.wide_nodes()[f].child_count; ++i, ++boxes) {
          const WideNodeChild& child = tree.child(f, i);
          const Box<float> box = get_box(body.wide_node_boxes(f), i);
          all.merge(box);
          wrong +=
              !same(box, child.cluster >= 0 ? body.clusters().cluster(child.cluster).box : body.wide_node_box(child.wide_node));
        }
        wrong += !same(body.wide_node_box(f), all);
        smaller += f % 2 == 0 && body.wide_node_box(f).extent() < bounds[f / 2].extent();
      }
      wrong += body.nodes_bounded() != bounded;
    }
    return Checked(wrong == 0 && smaller > 10, boxes, std::to_string(smaller) + " are smaller than the bounds before");
  });
}

void two_walking_men(Suite& t) {
  t.example("no more is looked at than is near: boxes, pairs of triangles and vertices of two men, at three distances", {}, [] {
    TwoMen men;
    auto &a = men.a, &b = men.b;
    struct Most {
      double distance;
      long ball_tests, triangle_tests, vertices, nodes;
    };
    bool ok = true;
    std::string text;
    for (const Most& most :
         {Most{0.6, 345, 100, 760, 102}, Most{0.35, 1650, 2960, 6800, 102}, Most{0.1, 2400, 7950, 13400, 102}}) {
      a.begin(men.at(0.2), {}), b.begin(men.at(0.7), moved(most.distance));
      QueryCounts counts;
      collide(a, b, Query::full, counts);
      QueryCounts of_first;  // This counts one pair, which ends the query.
      const auto first = collide(a, b, Query::yes_no, of_first);
      ok = ok && (first.empty() || 4 * of_first.triangle_tests < counts.triangle_tests);
      const long vertices = a.vertices_skinned() + b.vertices_skinned(), nodes = a.nodes_bounded() + b.nodes_bounded();
      ok = ok && counts.ball_tests <= most.ball_tests && counts.triangle_tests <= most.triangle_tests &&
           vertices <= most.vertices && nodes <= most.nodes;
      text += std::to_string(counts.ball_tests) + " boxes, " + std::to_string(counts.triangle_tests) + " pairs, " +
              std::to_string(vertices) + " vertices, " + std::to_string(nodes) + " nodes; ";
    }
    return Checked(ok, 3, text);
  });
  t.example(
      "two walking men: nothing is bounded or skinned far apart, a part close by, and the pairs are those of the "
      "sphere trees",
      {}, [] {
        TwoMen men;
        auto &a = men.a, &b = men.b;
        const Pose early = men.at(0.2), late = men.at(0.7);
        Body p(men.man, compared_variant("spherical_repaired")), q(men.man, compared_variant("spherical_repaired"));
        bool ok = true;
        std::string text;
        for (const double distance : {5.0, 0.6, 0.1}) {
          const RigidTransform<double> at = moved(distance);
          a.begin(early, {}), b.begin(late, at), p.begin(early), q.begin(late);
          QueryCounts counts, unused;
          const auto pairs = sorted(collide(a, b, Query::full, counts));
          ok = ok && pairs == sorted(collide({p}, {q, at}, Query::full, unused));
          const long skinned = a.clusters_skinned() + b.clusters_skinned();
          const auto all = 2 * static_cast<long>(men.tree.clusters().size());
          if (distance == 5.0) ok = ok && a.nodes_bounded() + b.nodes_bounded() == 0;  // their motion bounds are apart
          ok = ok && (distance == 5.0 ? skinned == 0 : distance == 0.1 ? pairs.size() > 100 : skinned < all / 2);
          text += std::to_string(skinned) + " of " + std::to_string(all) + " clusters skinned for " +
                  std::to_string(pairs.size()) + " pairs; ";
        }
        return Checked(ok, 3, text);
      });
  t.example("where two men's motion bounds begin to meet, each box of the first one's root is counted as compared", {}, [] {
    TwoMen men;
    const Pose pose = men.at(0);
    for (double distance = 5; distance > 0; distance -= 0.02) {
      men.a.begin(pose, {}), men.b.begin(pose, moved(distance));
      QueryCounts counts;
      collide(men.a, men.b, Query::full, counts);
      if (counts.ball_tests == 1) continue;  // the motion bounds are apart
      const int boxes = men.tree.wide_nodes()[0].child_count;
      return Checked(counts.ball_tests >= 1 + boxes && boxes > 8, 1,
                     std::to_string(counts.ball_tests) + " boxes are compared at " + std::to_string(distance));
    }
    return Checked(false, 0, "the motion bounds never meet");
  });
}

// Returns the pairs of bodies that are new, and remember nothing.
std::vector<TrianglePair> without_memory(const TwoMen& men, const Pose& first, const Pose& second,
                                         const RigidTransform<double>& place) {
  ClusterBody a(men.tree, Skinning::spherical), b(men.tree, Skinning::spherical);
  a.begin(first, {}), b.begin(second, place);
  QueryCounts counts;
  return collide(a, b, Query::full, counts);
}

void bodies_that_are_skinned_whole(Suite& t) {
  t.example(
      "bodies for which that is less work are skinned whole in the next frames, with the same pairs, and bounded again after "
      "them",
      {}, [] {
        TwoMen men;
        auto &a = men.a, &b = men.b;
        const RigidTransform<double> in_place = moved(0.02), near = moved(0.55), away = moved(5);
        PairMemory memory;
        bool ok = true;
        long queries = 0;
        const auto at = [&](double time, const RigidTransform<double>& place) {
          const Pose first = men.at(time), second = men.at(time + 0.5);
          a.begin(first, {}), b.begin(second, place);
          QueryCounts counts;
          const auto pairs = sorted(collide(a, b, Query::full, counts, &memory));
          ok = ok && pairs == sorted(without_memory(men, first, second, place));
          // All pairs of triangles take long, and are compared now and then.
          if (queries++ % 8 == 0)
            ok = ok && pairs == oracle::all_pairs({men.man, first, {}}, {men.man, second, place}, Skinning::spherical);
          const bool is_whole = a.is_all_skinned() && b.is_all_skinned();
          // Everything was skinned; or what was bounded besides is counted, too.
          ok = ok && (is_whole ? a.excess_work() == 0 && b.excess_work() == 0
                               : a.nodes_bounded() == 0 || a.excess_work() > -a.clusters().work_of_all());
          return is_whole;
        };
        const auto whole_in_a_row = [&](const RigidTransform<double>& place) {
          int count = 0;
          while (count < 100 && at(0.2 + 0.001 * count, place)) ++count;
          return count;
        };
        ok = ok && !at(0.2, in_place) && memory.are_entangled() && whole_in_a_row(in_place) == 16 && memory.are_entangled() &&
             whole_in_a_row(near) == 32 && !memory.are_entangled() && !at(0.2, near) && a.excess_work() + b.excess_work() < 0;
        ok = ok && !at(0.2, in_place) && at(0.2, in_place) && at(0.2, away) && !memory.are_entangled() && !at(0.2, away) &&
             a.nodes_bounded() == 0;
        // What spares less than a tenth of the work is not worth going through boxes for.
        ok = ok && !at(0.2, moved(0.32)) && memory.are_entangled() && a.excess_work() + b.excess_work() < 0;
        memory = {};
        // That one body was skinned whole before says nothing about the other one.
        QueryCounts counts;
        a.begin(men.at(0.2), {}), b.begin(men.at(0.7), moved(0.36));
        b.skin_all();
        collide(a, b, Query::full, counts, &memory);
        ok = ok && memory.are_near && !memory.are_entangled() && 5 * a.excess_work() > -a.work_of_all();
        // Clusters that touch again do not show how much work the next query does.
        ok = ok && !at(0.2, in_place) && memory.are_entangled() && collide(a, b, Query::yes_no, counts, &memory).size() == 1 &&
             !memory.are_entangled();
        // A frame that should have been skinned whole makes what is missing where it is asked for, and that is the same.
        ok = ok && !at(0.2, in_place) && memory.are_entangled();
        a.begin(men.walk.sample(0.1), in_place);
        ClusterBody fresh(men.tree, Skinning::spherical);
        fresh.begin(men.walk.sample(0.1), in_place);
        const Box<double> late = a.motion_bound(), soon = fresh.motion_bound();
        ok = ok && late.low == soon.low && late.high == soon.high && a.wide_node_box(0).low == fresh.wide_node_box(0).low;
        a.expect(ClusterBody::Need::skin);
        a.begin(men.walk.sample(0.1), in_place);
        ok = ok && a.wide_node_box(0).low == fresh.wide_node_box(0).low;
        try {
          a.begin(Pose(3), in_place);
          ok = false;
        } catch (const ModelError&) {
        }
        return Checked(ok, queries);
      });
}

void pairs_that_touch_and_pairs_that_are_remembered(Suite& t) {
  t.example("triangles that touch in a point, an edge or a plane are found, and boxes that only touch hide none", {}, [] {
    SkinnedMesh m;
    m.name = "triangle";
    m.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}};
    m.triangles = {{0, 1, 2}};
    m.joints = {{"root", -1, {0, 0, 0}}};
    m.influences.assign(3, {{0, 1.0}});
    const auto c = bake(std::move(m));
    const ClusterTree tree(c);
    ClusterBody first(tree, Skinning::spherical), second(tree, Skinning::spherical);
    const Pose still = reference_pose(c.mesh);
    first.begin(still, {});
    const auto pairs = [&](double x, double y, double z) {
      second.begin(still, moved(x, y, z));
      QueryCounts counts;
      return collide(first, second, Query::full, counts).size();
    };
    return Checked(pairs(2, 0, 0) == 1 && pairs(1, 1, 0) == 1 && pairs(0, 0, 0) == 1 && pairs(0.5, 0, 0) == 1 &&
                       pairs(2, 0, 1e-300) == 0 && pairs(std::nextafter(2, 3), 0, 0) == 0,
                   6);
  });
  t.example("clusters that touched answer a yes/no query if they still do, and no other is skinned for it", {}, [] {
    TwoMen men;
    auto &a = men.a, &b = men.b;
    const RigidTransform<double> at = moved(0.1), away = moved(1);
    PairMemory memory;
    QueryCounts counts;
    bool ok = true;
    for (const double time : {0.2, 0.2, 0.201}) {
      a.begin(men.at(time), {}), b.begin(men.at(time + 0.5), at);
      ok = ok && collide(a, b, Query::yes_no, counts, &memory).size() == 1;
    }
    ok = ok && a.clusters_skinned() == 1 && a.nodes_bounded() == 0 && memory.pairs().size() == 1 && !memory.are_entangled();
    b.begin(men.at(0.7), away);
    ok = ok && collide(a, b, Query::yes_no, counts, &memory).empty();
    b.begin(men.at(0.7), at);
    const auto pairs = collide(a, b, Query::full, counts, &memory);
    const auto& kept = memory.pairs();
    for (const ClusterPair& pair : kept)
      ok = ok && std::any_of(pairs.begin(), pairs.end(), [&](const TrianglePair& p) {
             return oracle::has_triangle(men.tree, pair.first, p.first) && oracle::has_triangle(men.tree, pair.second, p.second);
           });
    const std::size_t remembered = kept.size();
    memory.count_query(0);  // Otherwise they are skinned whole.
    // Motion bounds are compared again once the bounds have been found apart.
    for (const bool was_near : {true, false}) {
      a.begin(men.at(0.2), {}), b.begin(men.at(0.7), moved(5));
      ok = ok && memory.are_near == was_near && collide(a, b, Query::full, counts, &memory).empty() &&
           (a.nodes_bounded() > 0) == was_near;
    }
    return Checked(ok && remembered == PairMemory::most, 5,
                   std::to_string(pairs.size()) + " pairs found, " + std::to_string(remembered) + " remembered");
  });
}

// Checks slivers beside each other that hang over a plane, one of which hangs deeper and through it. The plane is in a box into
// which all of them reach.
void deepest_boxes_come_first(Suite& t) {
  t.example("a yes/no query looks first where boxes reach deepest into each other, wherever that is in the tree", {}, [] {
    constexpr int slivers = 12;
    SkinnedMesh plane;
    plane.name = "plane";
    plane.joints = {{"root", -1, {0, 0, 0}}};
    plane.vertices = {{-100, -100, -1.5}, {300, -100, -1.5}, {-100, 300, -1.5}, {1000, 0, -10}, {1000, 1, 0}, {1001, 0, 0}};
    plane.triangles = {{0, 1, 2}, {3, 4, 5}};
    plane.influences.assign(plane.vertices.size(), {{0, 1.0}});
    const Character below = bake(plane);
    const ClusterTree tree_below(below);
    long tried = 0;
    for (int through = 0; through < slivers; ++through) {
      SkinnedMesh row = row_of_triangles(slivers, 1, [](int) { return std::pair(0, 0); });
      for (int k = 0; k < slivers; ++k) {
        const double x = 4 * k, depth = k == through ? 2 : 1 + 0.02 * ((7 * k) % slivers);
        row.vertices[3 * k] = {x, 0, -depth}, row.vertices[3 * k + 1] = {x + 3, 0, 1}, row.vertices[3 * k + 2] = {x, 3, 1};
      }
      const Character above = bake(row);
      const ClusterTree tree(above, {.most_triangles = 1, .most_children = 32});
      ClusterBody first(tree, Skinning::spherical), second(tree_below, Skinning::spherical);
      for (const bool turned : {false, true}) {
        first.begin(Pose(1), {}), second.begin(Pose(1), {});
        QueryCounts counts;
        const auto found = turned ? collide(second, first, Query::yes_no, counts) : collide(first, second, Query::yes_no, counts);
        const TrianglePair expected = turned ? TrianglePair{0, through} : TrianglePair{through, 0};
        if (found != std::vector{expected} || first.clusters_skinned() != 1)
          return Checked(false, tried, std::to_string(first.clusters_skinned()) + " clusters for " + std::to_string(through));
        ++tried;
      }
    }
    return Checked(true, tried);
  });
}

void what_is_refused(Suite& t) {
  t.example("a body that has begun no frame is refused by name, and what a memory of other bodies remembers is passed over", {},
            [] {
              const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
              const ClusterTree tree(c);
              const Pose still = reference_pose(c.mesh);
              bool ok = true;
              for (const Skinning skinning : {Skinning::spherical, Skinning::linear, Skinning::dual_quaternion}) {
                ClusterBody a(tree, skinning), b(tree, skinning);
                QueryCounts counts;
                const auto is_refused = [&](const auto& call) { return gen::refuses<std::logic_error>(call); };
                ok = ok && is_refused([&] { collide(a, b, Query::full, counts); }) && is_refused([&] { a.wide_node_box(0); }) &&
                     is_refused([&] { a.clusters().cluster(0); }) && is_refused([&] { a.triangle(0); }) &&
                     is_refused([&] { a.clusters().padded_vertex(0, 0); }) &&
                     is_refused([&] { a.clusters().make_all_palettes(); }) && is_refused([&] { a.clusters().whole_palette(); });
                a.begin(still, {});
                ok = ok && is_refused([&] { collide(a, b, Query::full, counts); });
                PairMemory near;
                // The bounds of a body without a frame are then asked for within the query.
                near.are_near = true;
                ok = ok && is_refused([&] { collide(a, b, Query::full, counts, &near); });
                b.begin(still, {});
                ok = ok && gen::refuses<std::invalid_argument>([&] { collide(a, a, Query::full, counts); });
                PairMemory memory;
                const auto count = static_cast<int>(tree.clusters().size());
                for (const ClusterPair& pair : {ClusterPair{count, 0}, {0, count}, {-1, 0}, {0, 1 << 30}}) memory.remember(pair);
                ok = ok && collide(a, b, Query::yes_no, counts, &memory).size() == 1;
              }
              return Checked(ok, 30);
            });
  t.example("options out of range, a placement that is not rigid and a pose with a NaN are refused by name", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    const auto message = [](const auto& call) -> std::string {
      try {
        call();
        return "";
      } catch (const std::exception& e) {
        return e.what();
      }
    };
    const bool takes_edges = message([&] {
                               ClusterTree(c, {.most_triangles = 1, .most_children = 2});
                               ClusterTree(c, {.most_triangles = most_cluster_triangles});
                             }).empty(),
               refuses_more = !message([&] { ClusterTree(c, {.most_triangles = most_cluster_triangles + 1}); }).empty();
    const std::string small = message([&] { ClusterTree(c, {.most_triangles = 0}); }),
                      narrow = message([&] { ClusterTree(c, {.most_children = 1}); });
    const ClusterTree tree(c);
    ClusterBody body(tree, Skinning::spherical);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Pose still = reference_pose(c.mesh);
    const std::string stretched = message([&] {
      body.begin(still, {{2, 0, 0, 0}, {0, 0, 0}});
    }),
                      lost = message([&] {
                        body.begin(still, {{1, 0, 0, 0}, {nan, 0, 0}});
                      });
    Pose pose = still;
    pose[1].translation[2] = nan;
    const std::string refused = message([&] { body.begin(pose, {}); });
    for (const double off : {1e-6 - 1e-14, -1e-6 + 1e-14, 1e-6 + 1e-14, -1e-6 - 1e-14}) {
      const bool is_refused = !message([&] { body.begin(still, {{0, std::sqrt(1 + off), 0, 0}, {0, 0, 0}}); }).empty();
      if (is_refused != (std::abs(off) > 1e-6)) return Checked(false, 1, "at the edge of the tolerance");
    }
    return Checked(takes_edges && refuses_more && small.find("most_triangles is 0") != std::string::npos &&
                       narrow.find("most_children is 1") != std::string::npos &&
                       stretched.find("not rigid") != std::string::npos && lost.find("not finite") != std::string::npos &&
                       refused.find("joint 1") != std::string::npos,
                   5, small + "; " + narrow + "; " + stretched + "; " + lost + "; " + refused);
  });
}

}  // namespace

PROPTEST(cluster_collide) {
  pairs_are_those_of_testing_all(t);
  memories_of_others_and_places_far_away(t);
  a_needle_touches_where_a_bound_is_attained(t);
  leaves_that_are_too_large(t);
  clusters_and_wide_nodes(t);
  what_is_counted(t);
  when_clusters_are_rather_skinned(t);
  what_is_skinned_cuts_bounds(t);
  what_is_skinned_spares_others(t);
  boxes_once_all_is_skinned(t);
  two_walking_men(t);
  bodies_that_are_skinned_whole(t);
  deepest_boxes_come_first(t);
  pairs_that_touch_and_pairs_that_are_remembered(t);
  what_is_refused(t);
}

}  // namespace proptests::suite_cluster_collide
