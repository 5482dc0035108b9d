// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that refitted volumes hold every vertex: exactly, in rationals, where no root is needed; by intervals on the fallback;
// and in double up to rounding. It also tests the table of variants, on whole models.
#include "algorithms/methods/refit/volume_refit.hpp"

#include <cmath>
#include <thread>

#include "algorithms/methods/refit/volume_variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/rational_root.hpp"
#include "proptests/oracles/volume.hpp"

namespace proptests::suite_volume_refit {
namespace {

using namespace refitlab;
using gen::Blending;
using gen::RationalVec;
using gen::RefitCase;

// Calls visit with all kinds of volume of the case's node over S, the box turned as given.
template <class S, Blending blending, class Visit>
void for_each_volume(const RefitCase& c, const Quaternion<double>& orientation, const Visit& visit) {
  const gen::NodeOf<S> storage(c);
  const auto node = storage.node();
  ControlLists<S> lists;
  visit(refit_volume<Aabb<S>, blending>(node, lists));
  visit(refit_volume<KDop<S, 14>, blending>(node, lists));
  visit(refit_volume<KDop<S, 18>, blending>(node, lists));
  visit(refit_volume<KDop<S, 26>, blending>(node, lists));
  visit(refit_volume<Obb<S>, blending>(node, lists, convert<S>(orientation)));
}

RefitCase draw(gen::Turns turns) {
  const RefitCase c = *gen::refit_case(turns);
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  return c;
}

// Returns the exact images of the case's samples.
std::vector<RationalVec<3>> skinned_samples(const RefitCase& c, Blending blending, const Ball3<double>& far_from) {
  std::vector<RationalVec<3>> out;
  for (const auto& sample : gen::samples(c, blending, far_from.center))
    if (const auto v = gen::skinned(c, sample, blending)) out.push_back(*v);
  return out;
}

template <Blending blending>
std::vector<Ball3<double>> rounded_balls(const RefitCase& c) {
  const gen::NodeOf<double> storage(c);
  ControlLists<double> lists;
  const auto balls = certified_control_balls<blending>(storage.node(), lists);
  return {balls.begin(), balls.end()};
}

template <class S, Blending blending>
void assert_holds(const RefitCase& c, Verdict at_least) {
  const auto balls = rounded_balls<blending>(c);
  const auto vertices = skinned_samples(c, blending, balls[0]);
  const auto orientations = box_orientations(balls);
  for_each_volume<S, blending>(c, orientations[*rc::gen::inRange<std::size_t>(0, 5)], [&](const auto& volume) {
    for (const auto& v : vertices) RC_ASSERT(volume.contains(lift<S>(v)) >= at_least);
  });
}

void check_exactly() {
  const RefitCase c = draw(gen::Turns::any);
  assert_holds<Rational, Blending::linear>(c, Verdict::holds);
  try {
    assert_holds<Rational, Blending::spherical>(c, Verdict::holds);
    RC_TAG("exact");
  } catch (const NoRationalRoot&) {
    // Such a sample is on the boundary of a cap's ball.
    assert_holds<MultiprecisionInterval, Blending::spherical>(c, Verdict::undecided);
    RC_TAG("fallback");
  }
}

template <Blending blending>
void check_double() {
  const RefitCase c = gen::rounded_to_double(draw(gen::Turns::any));
  const auto balls = rounded_balls<blending>(c);
  const auto vertices = skinned_samples(c, blending, balls[0]);
  const gen::NodeOf<double> storage(c);
  long tried = 0;
  for (const VolumeVariant& variant : volume_variants()) {
    if (variant.skinning != blending) continue;
    ++tried;
    const Volume refitted = variant.refit(storage.node());
    RC_ASSERT(refitted.index() == variant.around(balls).index());
    if (oracle::is_all_of_space(refitted)) RC_ASSERT(balls.size() == 1 && std::isinf(balls[0].radius));
    for (const auto& v : vertices) RC_ASSERT(oracle::has(refitted, v));
  }
  RC_ASSERT(tried == 5);
  RC_CLASSIFY(std::isfinite(balls[0].radius), "bounded");
}

// Checks every node of a model in a pose, by two threads at once: each volume holds all of the node's deformed vertices.
Checked check_model(Model model, Skinning skinning) {
  const auto c = bake_animated(std::move(model));
  const Clip& clip = c.clips.back();
  const auto palette = make_skinning_palette(c.mesh, c.sets, clip.sample(0.8 * clip.duration), skinning);
  const auto deformed = skin(c.mesh, c.sets, palette, skinning);
  long checked[2] = {0, 0}, missed[2] = {0, 0};
  const auto work = [&](int part) {
    for (int n = part; n < static_cast<int>(c.tree.nodes.size()); n += 2)
      for (const VolumeVariant& variant : volume_variants()) {
        if (variant.skinning != skinning) continue;
        std::visit(
            [&](const auto& volume) {
              bool all = true;
              for (const int v : c.vertices[n]) all = all && volume.contains(deformed[v]) == Verdict::holds;
              ++checked[part];
              missed[part] += !all;
            },
            variant.refit(c.refit_node(n, palette, variant.pieces)));
      }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  return Checked(missed[0] + missed[1] == 0, checked[0] + checked[1],
                 std::to_string(missed[0] + missed[1]) + " volumes missed a vertex");
}

}  // namespace

PROPTEST(volume_refit) {
  t.holds("boxes, k-DOPs and oriented boxes hold every vertex of S with admissible weights, most of them exactly",
          {.form = "beyond",
           .number_type = "rational",
           .cases = 150,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"exact", 0.5}, {"fallback", 0.02}}},
          check_exactly);
  const Options in_double{.number_type = "double",
                          .cases = 400,
                          .degenerate_at_least = 0.2,
                          .degenerate_at_most = 0.5,
                          .tags_at_least = {{"bounded", 0.6}}};
  t.holds("every variant's volume holds every exactly skinned vertex of spherical blending", in_double,
          check_double<Blending::spherical>);
  t.holds("every variant's volume holds every exactly skinned vertex of linear blending", in_double,
          check_double<Blending::linear>);
  t.holds("every variant's volume holds every exactly skinned vertex of dual quaternion blending, or is all of space", in_double,
          check_double<Blending::dual_quaternion>);
  t.example("the variants are of five kinds for each skinning, in the order of Volume's", {}, [] {
    const char* const names[] = {"aabb", "dop14", "dop18", "dop26", "obb"};
    const std::pair<const char*, Skinning> prefixes[] = {
        {"", Skinning::spherical}, {"linear_", Skinning::linear}, {"dual_quaternion_", Skinning::dual_quaternion}};
    const std::vector<Ball3<double>> ball{{{1, 2, 3}, 0.5}};
    bool good = volume_variants().size() == 15;
    for (std::size_t i = 0; good && i < 15; ++i) {
      const VolumeVariant& variant = volume_variants()[i];
      const auto& [prefix, skinning] = prefixes[i / 5];
      good = variant.name == std::string(prefix) + names[i % 5] && variant.skinning == skinning &&
             variant.pieces == default_variant(skinning).pieces && variant.around(ball).index() == i % 5;
    }
    return good;
  });
  t.example("every node's volumes hold its deformed vertices, on two threads: the procedural man", {.number_type = "double"},
            [] { return check_model(make_man(), Skinning::spherical); });
  t.example("every node's volumes hold its linearly skinned vertices, on two threads: the procedural man",
            {.number_type = "double"}, [] { return check_model(make_man(), Skinning::linear); });
}

}  // namespace proptests::suite_volume_refit
