// SPDX-License-Identifier: GPL-3.0-or-later
// Tests skinning in float against the doubles that count, in exact arithmetic, over all that the interface accepts.
#include "algorithms/runtime/collide/skinned_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "algorithms/bake/bake.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/opposite_joints.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"

namespace proptests::suite_skinned_clusters {
namespace {

using namespace refitlab;

struct Compared {
  // Coordinates are within their slack or beyond it, and undefined where that is infinite.
  long within = 0, beyond = 0, undefined = 0;
  bool same_doubles = true, are_boxed = true, have_one_position = true;
  // This is the greatest error of a coordinate, as a share of the slack.
  double largest_share = 0;
};

// Compares every coordinate of every cluster's vertices.
Compared compare(SkinnedClusters& body, const std::vector<Point3>& expected) {
  Compared out;
  const ClusterTree& tree = body.tree();
  for (int c = 0; c < static_cast<int>(tree.clusters().size()); ++c) {
    const FloatCluster& cluster = body.cluster(c);
    const auto vertices = tree.vertices().vertices(c);
    const auto places = tree.floats().places(c);
    out.have_one_position = out.have_one_position && std::set<int>(vertices.begin(), vertices.end()).size() == places.size();
    for (std::size_t p = 0; p < places.size(); ++p)
      for (int i = 0; i < 3; ++i) {
        const double x = body.padded_vertex(c, static_cast<int>(p)).of[i];
        out.same_doubles = out.same_doubles && x == expected[vertices[places[p]]][i];
        if (!(cluster.slack < std::numeric_limits<float>::infinity())) {
          ++out.undefined;
          out.are_boxed = out.are_boxed && cluster.box.low[i] == -infinite && cluster.box.high[i] == infinite;
          continue;
        }
        const float f = cluster.xyz[i * tree.floats().room(c) + static_cast<int>(p)];
        if (!std::isfinite(f)) {
          ++out.beyond;
          continue;
        }
        const Rational seen = Rational(x) - Rational(body.origin()[i]), off = CGAL::abs(seen - Rational(f)), slack(cluster.slack);
        ++(off <= slack ? out.within : out.beyond);
        out.largest_share = std::max(out.largest_share, CGAL::to_double(off) / cluster.slack);
        out.are_boxed = out.are_boxed && Rational(cluster.box.low[i]) <= seen && seen <= Rational(cluster.box.high[i]);
      }
  }
  return out;
}

void assert_right(const Compared& c) {
  RC_ASSERT(c.same_doubles);
  RC_ASSERT(c.beyond == 0);
  RC_ASSERT(c.are_boxed);
  RC_ASSERT(c.have_one_position);
}

RigidTransform<double> drawn_placement(std::mt19937& random, double far) {
  std::normal_distribution<double> normal;
  const auto turn = gen::with_length(gen::random_rotation(random, 1), gen::random_unit_length(random), random);
  return {turn, Point3(normal(random), normal(random), normal(random)) * far};
}

Compared compare_placed(const Character& c, const Pose& pose, const RigidTransform<double>& at, const Point3& origin,
                        Skinning skinning, int most_triangles = 256) {
  const ClusterTree tree(c, {.most_triangles = most_triangles});
  SkinnedClusters body(tree, skinning);
  body.begin(pose, at, origin);
  if (most_triangles % 2) body.make_all_palettes();
  return compare(body, oracle::Posed{c, pose, at}.vertices(skinning));
}

// Makes triangles about one joint, turned by half a turn, whose image is known exactly.
SkinnedMesh about_one_joint() {
  SkinnedMesh m;
  m.name = "one joint";
  m.joints = {{"root", -1, {0, 0, 0}}};
  m.vertices = {{3, 1, 0}, {-3, 1, 0.5}, {0, -1, 2}};
  m.triangles = {{0, 1, 2}};
  m.influences.assign(3, {{0, 1.0}});
  return m;
}

void floats_are_within_their_slack(Suite& t) {
  t.holds(
      "floats are within their slack of the doubles, which are those of skinning: of one joint to many, turned any way",
      {.number_type = "rational", .cases = 400, .tags_at_least = {{"in float", 0.3}}}, [] {
        const auto plan = *gen::mesh_plan();
        const Character c = bake(gen::make_mesh(plan));
        std::mt19937 random(plan.seed);
        const double spread = *rc::gen::element(0.0, 1e-6, 1e-5, 1e-4, 1e-3, 0.1, 0.5, 3.0);
        const Pose pose = gen::with_lengths(gen::random_pose(c.mesh, random, spread), gen::random_unit_length(random), random);
        const auto at = drawn_placement(random, *rc::gen::element(0.0, 1.0, 1e3, 1e9));
        const Point3 origin = *rc::gen::arbitrary<bool>() ? at.translation : Point3::Zero();
        const auto skinning = *rc::gen::element(Skinning::spherical, Skinning::hejl, Skinning::linear, Skinning::dual_quaternion);
        const Compared all = compare_placed(c, pose, at, origin, skinning, *rc::gen::element(1, 7, 256));
        RC_TAG(all.undefined > 0                                               ? "undefined"
               : skinning == Skinning::spherical || skinning == Skinning::hejl ? "in float"
                                                                               : "in double");
        assert_right(all);
      });
  t.holds("so they are at the ends of what is accepted: up to 90 joints, of any size, quaternions off unit length",
          {.number_type = "rational", .cases = 600, .tags_at_least = {{"undefined", 0.05}, {"within", 0.3}}}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const gen::WideModel wide = gen::wide_model(random, *rc::gen::element(1, 2, 4, 90));
            const Character c = bake(wide.mesh, {.triangles_per_leaf = wide.triangles_per_leaf});
            const double unit = std::min(wide.largest_length, 1e20);
            const auto at = drawn_placement(random, unit * *rc::gen::element(0.0, 1.0, 1e6));
            const Point3 origin = random() % 2 ? at.translation : Point3(0, 0, 0);
            RC_LOG() << wide.what;
            const Compared all = compare_placed(c, wide.pose, at, origin, random() % 4 ? Skinning::spherical : Skinning::hejl);
            RC_TAG(all.undefined > 0 ? "undefined" : "within");
            assert_right(all);
          });
  t.holds("so they are where a bound is attained, at every scale and place", {.number_type = "rational", .cases = 600}, [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const double unit = *rc::gen::element(1.0, 1.0, 1e-12, 1e-36, 1e-40, 1e-44, 1e-160, 1e-300, 1e11, 1e12, 1e18, 1e35),
                 far = *rc::gen::element(0.0, 0.0, 1.0, 1e6, 1e30);
    const gen::Attained scene = gen::attained(random, {.unit = unit, .far = far, .joints = *rc::gen::element(1, 2, 3, 4, 0)});
    const Character c = bake(scene.mesh);
    RC_LOG() << scene.what;
    assert_right(compare_placed(c, scene.pose, scene.placement, random() % 2 ? scene.placement.translation : Point3(0, 0, 0),
                                Skinning::spherical));
  });
  t.holds(
      "so they are where blends nearly vanish, which doubles skin where the hypothesis of a long blend fails",
      {.number_type = "rational", .cases = 300, .tags_at_least = {{"within a right angle", 0.1}, {"beyond a right angle", 0.1}}},
      [] {
        const auto soup = gen::opposite_joints(*rc::gen::arbitrary<unsigned>());
        RC_TAG(gen::label_of(soup));
        const Character c = bake(soup.mesh);
        assert_right(compare_placed(c, soup.pose, {}, Point3::Zero(), Skinning::spherical));
      });
}

constexpr float untouched = -12345;  // what is not to be written

// Holds what one target skins in float of a cluster: the sides of its box, then all vertices.
struct FloatImage {
  float slack;
  std::vector<float> numbers;
};

// Returns the images of all clusters whose slacks are finite.
std::vector<FloatImage> skinned_by(Target target, const ClusterTree& tree, const Pose& pose, Skinning skinning) {
  const Character& c = tree.character();
  const PalettePacks packs(c.mesh, c.sets, skinning);
  const FloatPlacement at = {{0.8, 0, -0.6, 0}, {1, 2, -3}, 0, 0};
  std::vector<FloatPaletteEntry> palette(c.sets.count());
  for (int part = 0; part < packs.part_count(); ++part) packs.make_floats(packs.sets_of(part), pose, at, palette.data(), target);
  std::vector<FloatImage> out;
  for (int n = 0; n < static_cast<int>(tree.clusters().size()); ++n) {
    const auto runs = tree.floats().runs(n);
    if (std::any_of(runs.begin(), runs.end(), [&](const FloatRun& r) { return !std::isfinite(palette[r.joint_set].slack); }))
      continue;
    const auto room = static_cast<std::size_t>(tree.floats().room(n)), count = tree.floats().places(n).size();
    std::vector<float> numbers(3 * room + Lanes<float>::count, untouched);
    Box<float> box;
    FloatImage& image = out.emplace_back(FloatImage{tree.floats().skin(n, palette.data(), numbers.data(), box, target), {}});
    for (const auto* side : {&box.low, &box.high}) image.numbers.insert(image.numbers.end(), side->begin(), side->end());
    for (int i = 0; i < 3; ++i)
      image.numbers.insert(image.numbers.end(), numbers.begin() + i * room, numbers.begin() + i * room + count);
    RC_ASSERT(std::all_of(numbers.begin() + 3 * room, numbers.end(), [](float x) { return x == untouched; }));
  }
  return out;
}

void floats_by_every_target(Suite& t) {
  t.holds("every target skins in float to the same places, but for the slack, and writes to its room alone",
          {.cases = 200, .tags_at_least = {{"skinned", 0.5}}}, [] {
            const auto plan = *gen::mesh_plan();
            const Character c = bake(gen::make_mesh(plan));
            std::mt19937 random(plan.seed);
            const Pose pose = gen::random_pose(c.mesh, random, *rc::gen::element(0.0, 1e-3, 0.1, 0.5));
            const ClusterTree tree(c, {.most_triangles = *rc::gen::element(1, 7, 256)});
            const auto skinning = *rc::gen::element(Skinning::spherical, Skinning::hejl);
            const std::vector<FloatImage> expected = skinned_by(best_target(), tree, pose, skinning);
            for (const Target target : available_targets()) {
              const std::vector<FloatImage> found = skinned_by(target, tree, pose, skinning);
              RC_ASSERT(found.size() == expected.size());
              for (std::size_t n = 0; n < found.size(); ++n) {
                RC_ASSERT(std::abs(found[n].slack - expected[n].slack) <= 1e-3f * expected[n].slack);
                for (std::size_t i = 0; i < found[n].numbers.size(); ++i)
                  RC_ASSERT(std::abs(found[n].numbers[i] - expected[n].numbers[i]) <= found[n].slack);
              }
            }
            RC_TAG(expected.empty() ? "not skinned in float" : "skinned");
          });
}

void slacks_of_placements_and_of_a_walking_man(Suite& t) {
  t.example("a placement off unit length stretches what it turns, and the slack has that", {}, [] {
    const Character c = bake(about_one_joint());
    double largest = 0;
    bool ok = true;
    for (const double defect : {-1e-6, 1e-6}) {
      const Quaternion<double> half_turn(0, 0, 0, std::sqrt(1 + defect * 0.999));
      const Compared all = compare_placed(c, Pose(1), {half_turn, Point3::Zero()}, Point3::Zero(), Skinning::spherical);
      ok = ok && all.beyond == 0 && all.undefined == 0;
      largest = std::max(largest, all.largest_share);
    }
    return Checked(ok && largest > 0.2, 2, std::to_string(largest) + " of the slack");
  });
  t.example("of a walking man all is skinned in float, and what is lost is no small share of the slack", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man);
    SkinnedClusters body(tree, Skinning::spherical);
    Compared all;
    bool ok = true;
    for (int frame = 0; frame < 5; ++frame) {
      const Pose pose = man.clips[0].sample(0.2 * frame * man.clips[0].duration);
      body.begin(pose, {}, Point3::Zero());
      all = compare(body, oracle::Posed{man, pose, {}}.vertices(Skinning::spherical));
      ok = ok && all.beyond == 0 && all.undefined == 0 && all.same_doubles && all.are_boxed && all.largest_share > 0.05 &&
           all.largest_share < 0.7;
      float most = 0;
      for (int c = 0; c < static_cast<int>(tree.clusters().size()); ++c) most = std::max(most, body.cluster(c).slack);
      ok = ok && most < 3e-5f;  // a man is 1.8 units high
    }
    return Checked(ok, all.within, std::to_string(all.largest_share) + " of the slack");
  });
}

}  // namespace

PROPTEST(skinned_clusters) {
  floats_are_within_their_slack(t);
  floats_by_every_target(t);
  slacks_of_placements_and_of_a_walking_man(t);
  t.example("single triangles have the very doubles, and clusters and vertices are counted once a frame", {}, [] {
    const auto man = bake_animated(make_man());
    const ClusterTree tree(man);
    SkinnedClusters body(tree, Skinning::spherical);
    const Pose pose = man.clips[0].sample(0.3);
    const RigidTransform<double> at{gen::of_defect(identity_quaternion<double>(), 1e-9), {1, 2, 3}};
    const auto expected = oracle::Posed{man, pose, at}.vertices(Skinning::spherical);
    bool ok = true;
    for (int time = 0; time < 2; ++time) {
      body.begin(pose, at, at.translation);
      ok = ok && !body.is_all_skinned() && body.clusters_skinned() == 0 && body.vertices_skinned() == 0;
      for (int t = 0; t < 200; ++t) {
        const TrianglePoints points = body.triangle(t);
        for (int i = 0; i < 3; ++i) ok = ok && points[i] == expected[man.mesh.triangles[t][i]];
      }
      long places = 0;
      for (const Cluster& c : tree.clusters()) places += c.padded_vertex_count;
      body.skin_all(), body.skin_all();
      const int count = static_cast<int>(tree.clusters().size());
      ok = ok && body.is_all_skinned() && body.clusters_skinned() == count && body.vertices_skinned() == places;
      const auto same = [](const Box<float>& a, const Box<float>& b) { return a.low == b.low && a.high == b.high; };
      Box<float> around = Box<float>::empty(), all = around;
      for (int c = 0; c < count; ++c) {
        const Box<float>& box = body.cluster(c).box;
        ok = ok && same(get_box(body.boxes(), c), box);
        around.merge(box), all.merge(box);
        if (c % boxes_of_block != boxes_of_block - 1 && c != count - 1) continue;
        ok = ok && same(get_box(body.boxes_around_blocks(), c / boxes_of_block), around);
        around = Box<float>::empty();
      }
      ok = ok && same(body.box_around_all(), all);
    }
    return Checked(ok, 400);
  });
}

}  // namespace proptests::suite_skinned_clusters
