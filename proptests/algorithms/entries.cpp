// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every public entry that bounds or decides, over all that the interface accepts: joint-sets of 1 to 90 joints, lengths
// from denormal to 1e40, quaternions as doubles, as floats and at the edge of the tolerance, leaves of one triangle and of all.
// Each case is labelled with what was drawn, and each label has a least share. Vertices are skinned exactly; pairs are compared
// with all pairs.
#include <functional>
#include <random>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/wide_character.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"

namespace proptests::suite_entries {
namespace {

using namespace refitlab;
using gen::WidePlan;

// The exponents are those of two: the least is that of denormals, and the greatest keeps coordinates below 1e40.
constexpr int least_exponent = -1074, greatest_exponent = 130;

const std::map<std::string, double> ranges{{"1 joint", 0.03},
                                           {"2 to 4 joints", 0.2},
                                           {"5 to 17 joints", 0.2},
                                           {"90 joints", 0.05},
                                           {"denormal lengths", 0.05},
                                           {"squares underflow", 0.05},
                                           {"ordinary lengths", 0.1},
                                           {"squares overflow a float", 0.05},
                                           {"quaternions as doubles", 0.2},
                                           {"quaternions as floats", 0.2},
                                           {"quaternions at the tolerance", 0.2},
                                           {"one triangle a leaf", 0.2},
                                           {"all triangles in a leaf", 0.2}};

void tag(const WidePlan& plan, int triangles_per_leaf) {
  RC_TAG(plan.joints == 1 ? "1 joint" : plan.joints < 5 ? "2 to 4 joints" : plan.joints < 18 ? "5 to 17 joints" : "90 joints");
  RC_TAG(plan.exponent < -1022  ? "denormal lengths"
         : plan.exponent < -511 ? "squares underflow"
         : plan.exponent < -60  ? "tiny lengths"
         : plan.exponent < 60   ? "ordinary lengths"
                                : "squares overflow a float");
  RC_TAG(plan.lengths == 0   ? "quaternions as doubles"
         : plan.lengths == 1 ? "quaternions as floats"
                             : "quaternions at the tolerance");
  RC_TAG(triangles_per_leaf == 1 ? "one triangle a leaf" : "all triangles in a leaf");
}

struct World {
  explicit World(const WidePlan& plan, int triangles_per_leaf)
      : character(bake(gen::wide_model(plan), {.triangles_per_leaf = triangles_per_leaf})),
        pose(gen::wide_pose(plan, character.mesh)) {}
  Character character;
  Pose pose;
};

World drawn_world() {
  const WidePlan plan = *gen::wide_plan(least_exponent, greatest_exponent);
  const int triangles_per_leaf = *rc::gen::element(1, 1000);
  tag(plan, triangles_per_leaf);
  return World(plan, triangles_per_leaf);
}

// Holds the truth for one skinning: its palette, and the vertices as exact arithmetic and as skin() skins them.
class Truth {
 public:
  Truth(const World& w, Skinning skinning)
      : character_(w.character),
        palette_(make_skinning_palette(w.character.mesh, w.character.sets, w.pose, skinning)),
        exact_(w.character.mesh, w.character.sets, palette_, skinning),
        skinned_(skin(w.character.mesh, w.character.sets, palette_, skinning)) {}
  const SkinningPalette<double>& palette() const { return palette_; }

  // Says whether the balls of all nodes hold their vertices, skinned either way.
  template <class Balls>
  bool is_held_by(const Balls& ball_of) {
    for (int n = 0; n < static_cast<int>(character_.tree.nodes.size()); ++n) {
      const auto given = ball_of(n);
      const Ball3<double> ball{given.center.template cast<double>(), static_cast<double>(given.radius)};
      for (const int v : character_.vertices[n])
        if (!exact_.is_in(ball, v) || !holds(ball, skinned_[v])) return false;
    }
    return true;
  }

 private:
  static bool holds(const Ball3<double>& ball, const Point3& p) {
    if (ball.radius == HUGE_VAL) return true;
    return encloses(Ball<Rational, 3>{convert<Rational>(ball.center), Rational(ball.radius)}, convert<Rational>(p)) ==
           Verdict::holds;
  }
  const Character& character_;
  const SkinningPalette<double> palette_;
  ExactSkin exact_;
  const std::vector<Point3> skinned_;
};

// Says whether the work holds. It may also refuse lengths that are too large for single precision, with a message that says so.
bool holds_or_refuses(const std::function<bool()>& work) {
  try {
    return work();
  } catch (const std::range_error& e) {
    return std::string(e.what()).starts_with("refit in single precision: a length of ");
  }
}

bool is_held_by_variants(const World& w) {
  bool ok = true;
  for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
    Truth truth(w, skinning);
    for (const RefitVariant& variant : compared_variants()) {
      if (variant.skinning != skinning || !variant.sound) continue;
      const auto balls = refit_all(w.character, variant, truth.palette());
      ok = ok && truth.is_held_by([&](int n) { return balls[n]; });
    }
    FrameRefits refits(w.character, default_variant(skinning), {.most_joint_sets = 2, .children_first = true});
    refits.begin(truth.palette()), refits.refit_all();
    ok = ok && truth.is_held_by([&](int n) { return refits[n]; });
  }
  return ok;
}

bool is_held_by_batches(const World& w) {
  Truth linear(w, Skinning::linear), spherical(w, Skinning::spherical);
  bool ok = true;
  BatchRefit batch(w.character.tree, w.character.sets);
  for (const Target target : available_targets()) {
    ok = ok && holds_or_refuses([&] {
           const PackedBalls& balls = batch.linear(linear.palette(), target);
           return linear.is_held_by([&](int n) { return balls[n]; });
         });
    ok = ok && holds_or_refuses([&] {
           const PackedBalls& balls = batch.spherical(spherical.palette(), target);
           return spherical.is_held_by([&](int n) { return balls[n]; });
         });
  }
  return ok;
}

// Says whether poses and skins in packs are those of one at a time, exactly.
bool are_packs_the_same(const World& w, Skinning skinning) {
  const auto& c = w.character;
  const auto palette = make_skinning_palette(c.mesh, c.sets, w.pose, skinning);
  const auto expected = skin(c.mesh, c.sets, palette, skinning);
  bool ok = true;
  for (const Target target : available_targets()) {
    SkinningPalette<double> packed;
    PalettePacks(c.mesh, c.sets, skinning).make(w.pose, packed, target);
    std::vector<Point3> skinned(expected.size());
    PackedVertices(c.mesh, c.sets).skin_all(packed, skinning, skinned, target);
    ok = ok && skinned == expected;
  }
  return ok;
}

// Says whether the pairs of two bodies of one character are right, placed anywhere, near each other or far apart.
bool are_pairs_right(const World& w, Skinning skinning, std::mt19937& random) {
  double size = 0;
  for (const Point3& p : w.character.mesh.vertices) size = std::max(size, p.lpNorm<Eigen::Infinity>());
  const RigidTransform<double> here{}, there = gen::accepted_placement(random, size);
  const auto expected = oracle::all_pairs({w.character, w.pose, here}, {w.character, w.pose, there}, skinning);
  const ClusterTree tree(
      w.character, {.most_triangles = 1 + static_cast<int>(random() % 8), .most_children = 2 + static_cast<int>(random() % 6)});
  ClusterBody a(tree, skinning), b(tree, skinning);
  a.begin(w.pose, here), b.begin(w.pose, there);
  QueryCounts counts;
  bool ok = oracle::sorted(collide(a, b, Query::full, counts)) == expected;
  ok = ok && collide(a, b, Query::yes_no, counts).empty() == expected.empty();
  ClusterBody* const bodies[] = {&a, &b};
  CrowdCounts crowd;
  const auto contacts = collide_all(bodies, Query::full, crowd);
  ok = ok && contacts.size() == (expected.empty() ? 0u : 1u) &&
       (expected.empty() || oracle::sorted(contacts[0].pairs) == expected);
  if (skinning == Skinning::hejl) return ok;
  Body body(w.character, default_variant(skinning));
  body.begin(w.pose);
  return ok && oracle::sorted(collide({body, here}, {body, there}, Query::full, counts)) == expected;
}

Options over_all_ranges(int cases) { return {.number_type = "double", .cases = cases, .tags_at_least = ranges}; }

}  // namespace

PROPTEST(entries) {
  t.holds("every sound variant and FrameRefits hold all vertices, skinned exactly and by skin()", over_all_ranges(60),
          [] { RC_ASSERT(is_held_by_variants(drawn_world())); });
  t.holds("BatchRefit holds all vertices on every target, or refuses lengths beyond single precision", over_all_ranges(120),
          [] { RC_ASSERT(is_held_by_batches(drawn_world())); });
  t.holds("PalettePacks and PackedVertices are make_skinning_palette and skin, to the last bit, on every target",
          over_all_ranges(120), [] { RC_ASSERT(are_packs_the_same(drawn_world(), gen::drawn_skinning())); });
  t.holds("collide of clusters, of sphere trees and of crowds find the pairs that testing all pairs finds", over_all_ranges(120),
          [] {
            const World w = drawn_world();
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const Skinning skinning = gen::random_skinning(random);
            RC_ASSERT(are_pairs_right(w, skinning, random));
          });
}

}  // namespace proptests::suite_entries
