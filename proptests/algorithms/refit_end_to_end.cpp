// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every sound refit variant on nodes of whole models, against vertices that are skinned exactly and as skin() does. None
// may be outside, exactly. Besides, it counts how many would be outside without the slack for rounding.
#include <algorithm>
#include <filesystem>
#include <map>
#include <random>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/real_models.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/wide_character.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_refit_end_to_end {
namespace {

using namespace refitlab;

constexpr int nodes_per_pose = 200, vertices_per_node = 16;

// Returns the poses at two times of each of at most three clips. None of the times is a key time, where poses tend to be too
// simple.
std::vector<Pose> poses_of(const AnimatedCharacter& c) {
  std::vector<Pose> out;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, c.clips.size()); ++i)
    for (const double share : {0.3718, 0.9141}) out.push_back(c.clips[i].sample(share * c.clips[i].duration));
  if (out.empty()) out.push_back(reference_pose(c.mesh));
  return out;
}

struct Tally {
  long vertices = 0, misses = 0, float_misses = 0, skinned_misses = 0, misses_without_slack = 0;
};

// Says exactly whether the ball has the vertex, by squares. The ball's numbers are taken as they are.
bool has(const Ball3<double>& ball, const Point3& v) {
  const Ball3<Rational> exact{convert<Rational>(ball.center), Rational(ball.radius)};
  const Verdict quick = encloses(Ball3<Interval>{convert<Interval>(ball.center), Interval(ball.radius)}, convert<Interval>(v));
  return (quick == Verdict::undecided ? encloses(exact, convert<Rational>(v)) : quick) == Verdict::holds;
}

// Returns the first nodes, which carry many joint-sets, and random others.
std::vector<int> some_nodes(const Character& c, std::mt19937& random) {
  const int n = static_cast<int>(c.tree.nodes.size());
  std::vector<int> out;
  for (int i = 0; i < nodes_per_pose; ++i)
    out.push_back(i < nodes_per_pose / 4 ? std::min(i, n - 1) : std::uniform_int_distribution<int>(0, n - 1)(random));
  return out;
}

Checked check_model(Model model) {
  const auto c = bake_animated(std::move(model));
  std::mt19937 random(2006);
  std::map<std::string, Tally> tallies;
  for (const Pose& pose : poses_of(c))
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::hejl, Skinning::dual_quaternion}) {
      // Hejl's rotation center changes the palette, not the bound, so that spherical variants must hold for it too.
      const Skinning bounded = skinning == Skinning::hejl ? Skinning::spherical : skinning;
      const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
      const auto skinned = skin(c.mesh, c.sets, palette, skinning);
      ExactSkin exact(c.mesh, c.sets, palette, skinning);
      for (const int n : some_nodes(c, random)) {
        const auto all = c.vertices[n];
        std::vector<int> vertices;
        std::sample(all.begin(), all.end(), std::back_inserter(vertices), vertices_per_node, random);
        for (const RefitVariant& variant : compared_variants()) {
          if (!variant.sound || variant.skinning != bounded) continue;
          const RefitNode<double> node = c.refit_node(n, palette, variant.pieces);
          const Ball3<double> ball = variant.refit(node), bare = variant.refit_as_computed(node);
          const Ball3<float> small = rounded_outward(ball);
          const Ball3<double> of_floats{small.center.cast<double>(), small.radius};
          Tally& tally = tallies[variant.name];
          for (const int v : vertices) {
            ++tally.vertices;
            tally.misses += !exact.is_in(ball, v);
            tally.float_misses += !exact.is_in(of_floats, v);
            tally.skinned_misses += !has(ball, skinned[v]);
            tally.misses_without_slack += !exact.is_in(bare, v);
          }
        }
      }
    }
  long vertices = 0;
  bool passed = !tallies.empty();
  std::string text = std::to_string(c.tree.nodes.size()) + " nodes; without the slack for rounding outside:";
  for (const auto& [name, tally] : tallies) {
    char part[200];
    std::snprintf(part, sizeof part, " %s %.2f %%,", name.c_str(),
                  100.0 * double(tally.misses_without_slack) / double(tally.vertices));
    text += part;
    vertices += tally.vertices;
    if (const long missed = tally.misses + tally.float_misses + tally.skinned_misses; missed > 0) {
      text += " (with it " + std::to_string(missed) + ")";
      passed = false;
    }
  }
  text.back() = ' ';
  return Checked(passed, vertices, text);
}

// Checks every node and vertex of a small character, by all sound variants: what is accepted is bounded.
void check_wide() {
  const auto plan = *gen::wide_plan(-1074, 130);
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  const char* const lengths[] = {"double", "float", "at the tolerance"};
  RC_TAG(lengths[plan.lengths]);
  RC_CLASSIFY(plan.influences > 16, "more than 16 influences");
  RC_CLASSIFY(std::abs(plan.exponent) >= 60, "huge or tiny");
  SkinnedMesh model = gen::wide_model(plan);
  const Pose pose = gen::wide_pose(plan, model);
  const auto c = bake(std::move(model), {.triangles_per_leaf = *rc::gen::element(1, 2, 5, 1 << 30)});
  const Skinning skinning = gen::drawn_skinning();
  const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
  const auto skinned = skin(c.mesh, c.sets, palette, skinning);
  ExactSkin exact(c.mesh, c.sets, palette, skinning);
  for (const RefitVariant& variant : compared_variants()) {
    if (!variant.sound || variant.skinning != (skinning == Skinning::hejl ? Skinning::spherical : skinning)) continue;
    const auto balls = refit_all(c, variant, palette);
    FrameRefits frame(c, variant, {.most_joint_sets = 2, .most_in_cut = 3, .children_first = true});
    frame.begin(palette);
    frame.refit_all();
    for (int n = 0; n < static_cast<int>(balls.size()); ++n)
      for (const int v : c.vertices[n]) {
        RC_ASSERT(balls[n].center.allFinite() && frame[n].center.allFinite());
        RC_ASSERT(exact.is_in(balls[n], v) && exact.is_in(frame[n], v));
        if (balls[n].radius != HUGE_VAL) RC_ASSERT(has(balls[n], skinned[v]));
      }
  }
}

const char* const sentence =
    "every sound variant's ball, in double and rounded to float, encloses the vertices, skinned exactly and in double: ";

}  // namespace

PROPTEST(refit_end_to_end) {
  const Options options{.number_type = "double against rational"};
  t.example("a variant that there is not is refused with the names of those there are", {}, [] {
    try {
      compared_variant("spherical");
      return false;
    } catch (const std::invalid_argument& e) {
      return std::string(e.what()).find("control_mixed") != std::string::npos;
    }
  });
  t.holds(
      "no sound variant misses a vertex of up to 90 joints, of any size, and turned by quaternions of any length that is "
      "accepted",
      {.number_type = "double against rational",
       .cases = 600,
       .degenerate_at_least = 0.1,
       .degenerate_at_most = 0.5,
       .tags_at_least = {{"at the tolerance", 0.2}, {"float", 0.2}, {"more than 16 influences", 0.05}, {"huge or tiny", 0.2}}},
      check_wide);
  t.example(sentence + std::string("the procedural man"), options, [] { return check_model(make_man()); });
  t.example(sentence + std::string("the procedural creature"), options, [] { return check_model(make_creature()); });
  // The path is relative to the root of the repository, from where the tests are run.
  const std::filesystem::path folder = "out/models";
  for (const char* file : real_models)
    t.example(sentence + std::string(file), options, [=] {
      const auto path = folder / file;
      return std::filesystem::exists(path) ? check_model(load_model(path.string()))
                                           : Checked::skip(path.string() + " is not there");
    });
}

}  // namespace proptests::suite_refit_end_to_end
