// SPDX-License-Identifier: GPL-3.0-or-later
// Refitted volumes hold every vertex: exactly, in rationals, where no root is needed, and by intervals on the fallback;
// in double up to rounding. And the table of variants, on whole models.
#include "algorithms/methods/refit/volume_refit.hpp"

#include <thread>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/volume_variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/rational_root.hpp"

namespace proptests::suite_volume_refit {
namespace {

using namespace refitlab;
using gen::RationalVec;
using gen::RefitCase;

// The numbers of double as they are.
template <int k>
KDop<Rational, k> as_exact(const KDop<double, k>& dop) {
  KDop<Rational, k> out;
  for (std::size_t i = 0; i < dop.low.size(); ++i) out.low[i] = dop.low[i], out.high[i] = dop.high[i];
  return out;
}
Obb<Rational> as_exact(const Obb<double>& box) {
  Obb<Rational> out{{}, convert<Rational>(box.low), convert<Rational>(box.high)};
  for (int i = 0; i < 3; ++i) out.axes[i] = convert<Rational>(box.axes[i]);
  return out;
}

// All kinds of volume of the case's node over S, the box turned as given; calls visit with each.
template <class S, class Visit>
void for_each_volume(const RefitCase& c, const Quaternion<double>& orientation, const Visit& visit) {
  const gen::NodeOf<S> storage(c);
  const auto node = storage.node();
  ControlLists<S> lists;
  visit(refit_volume<Aabb<S>>(node, lists));
  visit(refit_volume<KDop<S, 14>>(node, lists));
  visit(refit_volume<KDop<S, 18>>(node, lists));
  visit(refit_volume<KDop<S, 26>>(node, lists));
  visit(refit_volume<Obb<S>>(node, lists, convert<S>(orientation)));
}

RefitCase draw(gen::Turns turns) {
  const RefitCase c = *gen::refit_case(turns);
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  return c;
}

// Where the case's samples go, exactly.
std::vector<RationalVec<3>> skinned_samples(const RefitCase& c, const Ball3<double>& far_from) {
  std::vector<RationalVec<3>> out;
  for (const auto& sample : gen::samples(c, gen::Blending::spherical, far_from.center))
    if (const auto v = gen::skinned(c, sample, gen::Blending::spherical)) out.push_back(*v);
  return out;
}

std::vector<Ball3<double>> rounded_balls(const RefitCase& c) {
  const gen::NodeOf<double> storage(c);
  ControlLists<double> lists;
  const auto balls = control_balls(storage.node(), lists);
  return {balls.begin(), balls.end()};
}

template <class S>
void assert_holds(const RefitCase& c, Verdict at_least) {
  const auto balls = rounded_balls(c);
  const auto vertices = skinned_samples(c, balls[0]);
  const auto orientations = box_orientations(balls);
  for_each_volume<S>(c, orientations[*rc::gen::inRange<std::size_t>(0, 5)], [&](const auto& volume) {
    for (const auto& v : vertices) RC_ASSERT(volume.contains(lift<S>(v)) >= at_least);
  });
}

void check_exactly() {
  const RefitCase c = draw(gen::Turns::any);
  try {
    assert_holds<Rational>(c, Verdict::holds);
    RC_TAG("exact");
  } catch (const NoRationalRoot&) {
    assert_holds<MultiprecisionInterval>(c, Verdict::undecided);  // on the boundary of a cap's ball
    RC_TAG("fallback");
  }
}

void check_double() {
  const RefitCase c = gen::rounded_to_double(draw(gen::Turns::any));
  const auto balls = rounded_balls(c);
  const auto vertices = skinned_samples(c, balls[0]);
  const gen::NodeOf<double> storage(c);
  for (const VolumeVariant& variant : volume_variants()) {
    const Volume refitted = variant.refit(storage.node());
    RC_ASSERT(refitted.index() == variant.around(balls).index());
    std::visit(
        [&](const auto& volume) {
          const auto around = as_exact(volume);
          for (const auto& v : vertices) RC_ASSERT(around.contains(v) == Verdict::holds);
        },
        refitted);
  }
}

// Every node of a model in a pose, by two threads at once: each volume holds all of the node's deformed vertices.
Checked check_model(Model model) {
  const auto c = bake(std::move(model));
  const Clip& clip = c.clips.back();
  const auto palette = make_skinning_palette(c.mesh, c.sets, clip.sample(0.8 * clip.duration), Skinning::spherical);
  const auto deformed = skin(c.mesh, c.sets, palette, Skinning::spherical);
  long checked[2] = {0, 0}, missed[2] = {0, 0};
  const auto work = [&](int part) {
    for (int n = part; n < static_cast<int>(c.tree.nodes.size()); n += 2)
      for (const VolumeVariant& variant : volume_variants())
        std::visit(
            [&](const auto& volume) {
              bool all = true;
              for (const int v : c.vertices[n]) all = all && volume.contains(deformed[v]) == Verdict::holds;
              ++checked[part];
              missed[part] += !all;
            },
            variant.refit(c.refit_node(n, palette, variant.pieces)));
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
  t.holds("every variant's volume holds every exactly skinned vertex",
          {.number_type = "double", .cases = 700, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5}, check_double);
  t.example("the variants are of five kinds, in the order of Volume's", {}, [] {
    const char* const names[] = {"aabb", "dop14", "dop18", "dop26", "obb"};
    const std::vector<Ball3<double>> ball{{{1, 2, 3}, 0.5}};
    bool good = volume_variants().size() == 5;
    for (std::size_t i = 0; good && i < 5; ++i)
      good = volume_variants()[i].name == names[i] && volume_variants()[i].around(ball).index() == i;
    return good;
  });
  t.example("every node's volumes hold its deformed vertices, on two threads: the procedural man", {.number_type = "double"},
            [] { return check_model(make_man()); });
}

}  // namespace proptests::suite_volume_refit
