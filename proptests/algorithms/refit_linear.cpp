// SPDX-License-Identifier: GPL-3.0-or-later
// Tests refitting for linear blending.
#include "algorithms/runtime/refit/refit_linear.hpp"

#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/refits/refit_ladder.hpp"

namespace proptests::suite_refit_linear {
namespace {

using namespace refitlab;
using gen::Blending;
using gen::RefitCase;
using gen::Sample;

struct Linear {
  template <class S>
  Ball3<S> operator()(const RefitNode<S>& node) const {
    ControlLists<S> lists;
    return refit_linear<MeanBalls>(node, lists);
  }
};

// Asserts that no vertex is certainly outside. With `all_decided`, each must be certainly inside.
void check_enclosure(Blending blending, bool all_decided) {
  const RefitCase c = *gen::refit_case(gen::Turns::any);
  RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
  oracle::RefitLadder ladder(c, Linear{}, oracle::linear_ball(c));
  const Point3 center = Linear{}(gen::NodeOf<double>(c).node()).center;
  oracle::RungTally tally;
  for (const Sample& sample : gen::samples(c, blending, center))
    if (const auto v = gen::skinned(c, sample, blending)) {
      const Decision d = ladder.encloses(*v);
      tally.add(d);
      RC_ASSERT(d.verdict == Verdict::holds || (!all_decided && d.verdict == Verdict::undecided));
    }
  RC_CLASSIFY(tally.share("interval") > 0.6, "mostly by intervals of doubles");
}

}  // namespace

PROPTEST(refit_linear) {
  t.holds("the ball encloses every linearly skinned vertex of S with admissible weights",
          {.form = "linear blending",
           .number_type = "interval to exact",
           .cases = 2000,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"mostly by intervals of doubles", 0.5}}},
          [] { check_enclosure(Blending::linear, true); });
  t.refuted("the ball encloses every spherically skinned vertex of S with admissible weights",
            {.number_type = "interval to exact"}, [] { check_enclosure(Blending::spherical, false); });
  t.example(
      "a half-way twist of 180 degrees leaves the linear ball: the linear vertex sinks to the axis, the spherical one "
      "does not",
      {.number_type = "rational"}, [] {
        // The vertex p = (0, 1, 0) is halfway between the identity and a half-turn about x, with weights (1/2, 1/2): the linear
        // ball is the point 0.
        RefitCase c;
        c.reference = {{0, 1, 0}, Rational(0)};
        c.sets.emplace_back();
        auto& set = c.sets[0];
        set.palette.transforms.resize(2);
        set.palette.transforms[1].rotation = {0, 1, 0, 0};
        place_rotation_center<Rational>(set.palette, gen::RationalVec<3>::Zero());
        const std::vector<Rational> half(2, Rational(1, 2));
        set.weights = {{half, half}, {half}};
        oracle::RefitLadder ladder(c, Linear{}, oracle::linear_ball(c));
        const Sample sample{0, half, c.reference.center};
        return ladder.encloses(*gen::skinned(c, sample, Blending::linear)).verdict == Verdict::holds &&
               ladder.encloses(*gen::skinned(c, sample, Blending::spherical)).verdict == Verdict::fails;
      });
}

}  // namespace proptests::suite_refit_linear
