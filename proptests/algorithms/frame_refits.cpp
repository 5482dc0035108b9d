// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/refit/frame_refits.hpp"

#include <algorithm>
#include <random>
#include <set>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_frame_refits {
namespace {

using namespace refitlab;

Pose random_pose(const SkinnedMesh& model, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Pose pose = reference_pose(model);
  for (auto& t : pose) {
    t.rotation = {1 + normal(random), normal(random), normal(random), normal(random)};
    t.rotation.normalize();
    t.translation = {normal(random), normal(random), normal(random)};
  }
  return pose;
}

// Holds a drawn character in a random pose, or any other.
struct Drawn {
  Drawn(SkinnedMesh m, const Pose& pose, const RefitVariant& of)
      : variant(of),
        character(bake(std::move(m))),
        palette(make_skinning_palette(character.mesh, character.sets, pose, variant.skinning)),
        deformed(skin(character.mesh, character.sets, palette, variant.skinning)) {}
  Drawn(SkinnedMesh m, unsigned seed)
      : character(bake(std::move(m))),
        palette(make_skinning_palette(character.mesh, character.sets, random_pose(character.mesh, seed), variant.skinning)),
        deformed(skin(character.mesh, character.sets, palette, variant.skinning)) {}
  int count() const { return static_cast<int>(character.tree.nodes.size()); }
  Ball3<double> own(int n) const { return variant.refit(character.refit_node(n, palette, variant.pieces)); }
  int joint_sets(int n) const { return static_cast<int>(character.tree.refit_node(n, palette).pieces.size()); }
  bool encloses(const Ball3<double>& ball, int n) const {
    for (const int v : character.vertices[n])
      if (!(norm<double, 3>(deformed[v] - ball.center) <= ball.radius + 1e-12)) return false;
    return true;
  }

  const RefitVariant& variant = compared_variant("control_sets_miniball");
  Character character;
  SkinningPalette<double> palette;
  std::vector<Point3> deformed;
};

// Makes two strips of triangles. Where the vertices of the first are half-way between two joints, in cuts of which a third has
// hardly any weight, dual quaternions may blend to 0, so that their bound is all of space. The second strip is rigid.
SkinnedMesh two_strips() {
  SkinnedMesh m;
  m.name = "strips";
  for (int j = 0; j < 4; ++j) m.joints.push_back({"joint", j - 1, {0, 0, 0}});
  const auto add = [&](const Point3& p, const std::vector<std::pair<int, double>>& weights) {
    m.vertices.push_back(p);
    m.influences.emplace_back();
    for (const auto& [joint, weight] : quantize_weights(weights)) m.influences.back().push_back({joint, weight});
  };
  for (int i = 0; i < 6; ++i) add({1. * i, i % 2 * 1., 0}, {{0, 0x1p-22}, {1, 1. + i}, {2, 6. - i}});
  for (int i = 0; i < 6; ++i) add({1. * i, i % 2 * 1., 5}, {{3, 1}});
  for (const int t : {0, 1, 2, 3, 6, 7, 8, 9}) m.triangles.push_back({t, t + 1, t + 2});
  validate(m);
  return m;
}

Pose with_opposite_turns() {
  Pose pose(4);
  pose[1] = {{0, 1, 0, 0}, {1, 2, 3}};
  pose[2] = {{0, -1, 0, 0}, {0, 0, 0}};
  return pose;
}

// Returns a fault unless each ball encloses its vertices and is defined, and only those are all of space that have to be, and the
// balls above them.
std::string fault_of_infinite(const Drawn& d, const FrameOptions& options) {
  FrameRefits frame(d.character, d.variant, options);
  frame.begin(d.palette);
  frame.refit_all();
  long infinite = 0;
  for (int n = 0; n < d.count(); ++n) {
    const Ball3<double>& ball = frame[n];
    if (!ball.center.allFinite() || !(ball.radius >= 0) || !d.encloses(ball, n)) return "a ball that is undefined";
    bool is_expected = std::isinf(d.own(n).radius), finite_children = d.character.tree.nodes[n].child_count > 0;
    if (!frame.cut(n).empty()) is_expected = false;
    for (const int below : frame.cut(n)) is_expected = is_expected || std::isinf(frame[below].radius);
    for (int c = 0; c < d.character.tree.nodes[n].child_count; ++c)
      finite_children = finite_children && std::isfinite(frame[d.character.tree.nodes[n].first_child + c].radius);
    if (options.children_first && finite_children) is_expected = false;
    if (std::isinf(ball.radius) != is_expected) return "a ball that is all of space, or is not, for no reason";
    infinite += std::isinf(ball.radius);
  }
  return infinite == 0 || infinite == d.count() ? "of infinite and finite balls there is one kind only" : "";
}

Drawn draw() {
  const auto plan = gen::classified_plan();
  return {gen::make_mesh(plan), plan.seed};
}

// Returns the cut of a node by its definition: the member with the most joint-sets, or the first of several, is replaced by its
// children.
std::vector<int> cut_by_definition(const Drawn& d, int n, const FrameOptions& options) {
  const auto children = [&](int m) {
    std::vector<int> out;
    for (int c = 0; c < d.character.tree.nodes[m].child_count; ++c) out.push_back(d.character.tree.nodes[m].first_child + c);
    return out;
  };
  std::vector<int> cut = children(n);
  for (;;) {
    int widest = -1;
    for (const int m : cut)
      if (!children(m).empty() && d.joint_sets(m) > options.most_joint_sets &&
          (widest < 0 || d.joint_sets(m) > d.joint_sets(widest) || (d.joint_sets(m) == d.joint_sets(widest) && m < widest)))
        widest = m;
    if (widest < 0) return cut;
    const auto below = children(widest);
    if (static_cast<int>(cut.size() + below.size()) - 1 > options.most_in_cut) return cut;
    cut.erase(std::find(cut.begin(), cut.end(), widest));
    cut.insert(cut.end(), below.begin(), below.end());
  }
}

// Returns the ball that a frame must have of a node, from the definition alone, and collects the nodes that are refitted for it.
Ball3<double> ball_by_definition(const Drawn& d, int n, const FrameOptions& options, std::set<int>& refitted) {
  refitted.insert(n);
  if (d.joint_sets(n) <= options.most_joint_sets || d.character.tree.nodes[n].child_count == 0) return d.own(n);
  std::vector<Ball3<double>> balls;
  for (const int below : cut_by_definition(d, n, options)) balls.push_back(ball_by_definition(d, below, options, refitted));
  return few_balls_ball(balls).ball;
}

void balls_of_one_node(Suite& t) {
  t.holds("every ball encloses its vertices, in whatever order, with and without the frame's short cuts, frame after frame",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const Drawn d = draw();
            FrameRefits frame(d.character, d.variant,
                              {.most_joint_sets = *rc::gen::element(0, 1, 2, 4),
                               .most_in_cut = *rc::gen::element(2, 64),
                               .children_first = *rc::gen::arbitrary<bool>()});
            for (int round = 0; round < 3; ++round) {
              const auto palette = make_skinning_palette(d.character.mesh, d.character.sets,
                                                         random_pose(d.character.mesh, 77u + round), d.variant.skinning);
              const auto deformed = skin(d.character.mesh, d.character.sets, palette, d.variant.skinning);
              frame.begin(palette);
              std::mt19937 random(static_cast<unsigned>(round));
              for (int i = 0; i < 40; ++i) {
                const int n = static_cast<int>(random() % static_cast<unsigned>(d.count()));
                const Ball3<double> ball = frame[n];
                for (const int v : d.character.vertices[n])
                  RC_ASSERT((norm<double, 3>(deformed[v] - ball.center)) <= ball.radius + 1e-12);
              }
            }
          });
  t.holds("without short cuts a ball is the variant's own, made at the first question only",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const Drawn d = draw();
            FrameRefits frame(d.character, d.variant);
            frame.begin(d.palette);
            std::set<int> asked;
            for (int i = 0; i < 30; ++i) {
              const int n = *rc::gen::inRange(0, d.count());
              RC_ASSERT(frame.is_refitted(n) == (asked.count(n) == 1));
              asked.insert(n);
              const Ball3<double> own = d.own(n), got = frame[n];
              RC_ASSERT(got.center == own.center && got.radius == own.radius);
              long made = 0;
              for (const long level : frame.refitted_by_level()) made += level;
              RC_ASSERT(made == static_cast<long>(asked.size()));
            }
          });
}

void balls_from_children_and_from_below(Suite& t) {
  t.holds("children first: the ball is the smaller of the node's own and the smallest around its children's",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const Drawn d = draw();
            FrameRefits frame(d.character, d.variant, {.children_first = true});
            frame.begin(d.palette);
            frame.refit_all();
            for (int n = 0; n < d.count(); ++n) {
              const TreeNode& node = d.character.tree.nodes[n];
              double expected = d.own(n).radius;
              std::vector<Ball3<double>> children;
              for (int c = 0; c < node.child_count; ++c) children.push_back(frame[node.first_child + c]);
              if (!children.empty()) expected = std::min(expected, rounded_up(few_balls_ball(children).ball).radius);
              RC_ASSERT(frame[n].radius == expected);
              RC_ASSERT(d.encloses(frame[n], n));
            }
          });
  t.holds("from below: a node of many joint-sets gets the smallest ball around its cut's, which alone is refitted for it",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const Drawn d = draw();
            const FrameOptions options{.most_joint_sets = *rc::gen::element(1, 2, 3),
                                       .most_in_cut = *rc::gen::element(1, 3, 6, 64)};
            FrameRefits frame(d.character, d.variant, options);
            for (int n = 0; n < d.count(); n += n < 6 ? 1 : 4) {
              frame.begin(d.palette);
              const Ball3<double> ball = frame[n];
              std::set<int> expected;
              const double radius = ball_by_definition(d, n, options, expected).radius;
              RC_ASSERT(std::abs(ball.radius - radius) <= 1e-9 * radius);
              for (int m = 0; m < d.count(); ++m) RC_ASSERT(frame.is_refitted(m) == (expected.count(m) == 1));
              RC_TAG(expected.size() > 1 ? "from below" : "by itself");
            }
          });
  t.example("around a ball that is all of space is all of space, from below and of children, and only there", {}, [] {
    long frames = 0;
    for (const char* name :
         {"dual_quaternion_control_mean", "dual_quaternion_control_near", "dual_quaternion_control_miniball"}) {
      const Drawn d(two_strips(), with_opposite_turns(), compared_variant(name));
      for (const int most_joint_sets : {0, 1, 2})
        for (const int most_in_cut : {1, 2, 64})
          for (const bool children_first : {false, true}) {
            const std::string fault = fault_of_infinite(d, {most_joint_sets, most_in_cut, children_first});
            if (!fault.empty()) return Checked(false, frames, name + (": " + fault));
            ++frames;
          }
    }
    return Checked(true, frames);
  });
}

void what_is_counted_and_what_is_refused(Suite& t) {
  t.holds("the balls made since begin are counted by their levels, those for cuts too",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const Drawn d = draw();
            FrameRefits frame(d.character, d.variant, {.most_joint_sets = *rc::gen::element(0, 1, 3), .most_in_cut = 6});
            for (int round = 0; round < 3; ++round) {
              frame.begin(d.palette);
              for (int i = 0; i < 5 * (2 - round); ++i) frame[*rc::gen::inRange(0, d.count())];
              std::vector<long> expected(d.character.tree.level_count());
              for (int n = 0; n < d.count(); ++n)
                if (frame.is_refitted(n)) ++expected[d.character.tree.nodes[n].level - 1];
              RC_ASSERT(frame.refitted_by_level() == expected);
            }
          });
  t.example("a palette whose arrays were filled by hand is refused until it is measured, each time they are filled", {}, [] {
    const auto snake = bake(make_snake(5));
    const RefitVariant& variant = default_variant(Skinning::spherical);
    FrameRefits frame(snake, variant);
    SkinningPalette<double> palette;
    const PalettePacks packs(snake.mesh, snake.sets, Skinning::spherical);
    long filled = 0;
    for (const double far : {0.0, 1e9, 0.0, -1e18}) {
      Pose pose = reference_pose(snake.mesh);
      for (auto& joint : pose) joint.translation[1] = far;
      packs.make(pose, palette);
      ++filled;
      if (!gen::refuses<std::invalid_argument>([&] { frame.begin(palette); }) ||
          !gen::refuses<std::invalid_argument>([&] { refit_all(snake, variant, palette); }))
        return Checked(false, filled, "not refused");
      palette.measure();
      frame.begin(palette);
      // Balls that are so far from the origin have more room for rounding.
      const Ball3<double> expected =
          refit_all(snake, variant, make_skinning_palette(snake.mesh, snake.sets, pose, variant.skinning))[0];
      if (frame[0].center != expected.center || frame[0].radius != expected.radius || !(expected.radius > 1e-16 * std::abs(far)))
        return Checked(false, filled, "another ball");
    }
    return Checked(true, filled);
  });
}

}  // namespace

PROPTEST(frame_refits) {
  balls_of_one_node(t);
  balls_from_children_and_from_below(t);
  what_is_counted_and_what_is_refused(t);
  t.example("of the built-in man's inner nodes some are bounded from below, some by their children, some by themselves", {}, [] {
    static const Drawn man(make_man(), 2006);
    FrameRefits plain(man.character, man.variant), below(man.character, man.variant, {.most_joint_sets = 16}),
        children(man.character, man.variant, {.children_first = true});
    for (FrameRefits* frame : {&plain, &below, &children}) frame->begin(man.palette), frame->refit_all();
    long through_descendants = 0, smaller = 0, same = 0;
    for (int n = 0; n < man.count(); ++n) {
      if (man.character.tree.nodes[n].child_count == 0) continue;
      through_descendants += man.joint_sets(n) > 16;
      (children[n].radius < plain[n].radius ? smaller : same)++;
      if (children[n].radius > plain[n].radius || !man.encloses(below[n], n)) return Checked(false, n);
    }
    return Checked(through_descendants > 10 && smaller > 10 && same > 10, through_descendants + smaller + same,
                   std::to_string(through_descendants) + " from below; " + std::to_string(smaller) +
                       " smaller by their children, " + std::to_string(same) + " not");
  });
}

}  // namespace proptests::suite_frame_refits
