// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the theorem that the repaired Algorithm 1 encloses every vertex of S with admissible weights.
#include "algorithms/runtime/refit/algorithm1_repaired.hpp"

#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/refits/refit_ladder.hpp"

namespace proptests::suite_algorithm1_repaired {
namespace {

using namespace refitlab;
using gen::Blending;
using gen::RefitCase;
using gen::Sample;

// This policy takes the first of the points as the center, which shows that no choice of a center is unsound.
struct FirstPoints {
  template <class S, int D>
  static Vec<S, D> center_of_points(std::span<const Vec<S, D>> points) {
    return points[0];
  }
  template <class S>
  static Ball3<S> of_balls(std::span<const Ball3<S>> balls) {
    Ball3<S> out = balls[0];
    for (const auto& b : balls) out.radius = max_of(out.radius, S(norm<S, 3>(b.center - out.center) + b.radius));
    return out;
  }
};

template <class Policy>
struct Repaired {
  template <class S>
  Ball3<S> operator()(const RefitNode<S>& node) const {
    RefitLists<S> lists;
    return refit_algorithm1_repaired<Policy>(node, lists);
  }
};

void classify(const RefitCase& c) {
  const auto kinds = gen::degeneracies(c);
  RC_CLASSIFY(!kinds.empty(), "degenerate");
  for (const auto& kind : kinds) RC_TAG(kind);
  RC_TAG(c.sets.size() == 1 ? "one joint-set" : "several joint-sets");
}

template <class Policy>
void check_theorem(oracle::Gather gather) {
  const RefitCase c = *gen::refit_case(gen::Turns::any);
  classify(c);
  oracle::RefitLadder ladder(c, Repaired<Policy>{}, oracle::repaired_ball(c, gather));
  const Point3 center = Repaired<Policy>{}(gen::NodeOf<double>(c).node()).center;
  oracle::RungTally tally;
  for (const Sample& sample : gen::samples(c, Blending::spherical, center)) {
    const auto v = gen::skinned(c, sample, Blending::spherical);
    if (!v) continue;
    const Decision d = ladder.encloses(*v);
    tally.add(d);
    RC_ASSERT(d.verdict != Verdict::fails);
  }
  RC_PRE(tally.total() > 0);
  RC_CLASSIFY(tally.share("interval") > 0.6, "mostly by intervals of doubles");
  RC_CLASSIFY(tally.share(oracle::RungTally::none) == 0, "decided exactly");
}

// Says whether some weight vertex's blend all but vanishes. Rounding then turns it, which the last example is about.
bool has_short_blend(const RefitCase& c) {
  for (const auto& set : c.sets)
    for (const auto& weight_vertex : set.weights.vertices)
      if (const auto q = squared_norm(blend_quaternion<Rational>(set.palette, weight_vertex)); q != 0 && q < Rational(1, 1000000))
        return true;
  return false;
}

// Checks how far the ball of double misses the exactly skinned vertices of the same doubles, relative to the coordinates. The label
// says in how many cases it misses one at all.
template <class Policy>
void check_double() {
  const RefitCase c = gen::rounded_to_double(*gen::refit_case(gen::Turns::any));
  RC_PRE(!has_short_blend(c));
  const Ball3<double> ball = Repaired<Policy>{}(gen::NodeOf<double>(c).node());
  const Ball3<Rational> exact{{Rational(ball.center[0]), Rational(ball.center[1]), Rational(ball.center[2])},
                              Rational(ball.radius)};
  long vertices = 0;
  bool missed = false;
  for (const Sample& sample : gen::samples(c, Blending::spherical, ball.center)) {
    const auto v = gen::skinned(c, sample, Blending::spherical);
    if (!v) continue;
    ++vertices;
    if (encloses(exact, *v) == Verdict::holds) continue;
    missed = true;
    const Rational beyond = squared_distance(*v, exact.center) - exact.radius * exact.radius;
    double size = ball.center.norm() + ball.radius;
    for (const auto& set : c.sets) size += lift<double>(set.palette.rotation_center).norm();
    const double relative =
        CGAL::to_double(beyond) / (ball.radius + std::sqrt(CGAL::to_double(squared_distance(*v, exact.center)))) / size;
    RC_ASSERT(relative <= 1e-12);
  }
  RC_PRE(vertices > 0);
  RC_CLASSIFY(missed, "missed by rounding");
}

// Returns the length of one weight vertex's blend, and the miss relative to ||p||. The blend all but vanishes, so that its
// direction in double is mostly rounding: its three quaternions are 120 degrees apart, and the weights are off a third by some
// 2^-24.
std::pair<double, double> miss_of_short_blend(int off) {
  const double unit = std::ldexp(1, -24), third = 5592405 * unit;
  const std::vector<double> w{third + off * unit, third - off * unit, 1 - 2 * third};
  SkinningPalette<double> palette;
  const auto transforms = palette.append(3);
  const Quaternion<double> a(0.6, 0, 0.8, 0), b(0, 0.28, 0, 0.96);
  for (int j = 0; j < 3; ++j) {
    const double angle = 0.1 + j * 2 * std::acos(-1) / 3;
    transforms[j].rotation = a * std::cos(angle) + b * std::sin(angle);
  }
  palette.complete(Point3::Zero());
  const NodePiece set{0, 0, 1};
  const RefitNode<double> node{{{1, 2, 3}, 0}, {&set, 1}, w.data(), palette};
  const Ball3<double> ball = Repaired<MeanBalls>{}(node);
  OwnedPaletteEntry<Rational> exact;
  for (const auto& c : palette[0].transforms)
    exact.transforms.push_back({convert<Rational>(c.rotation), convert<Rational>(c.translation)});
  place_rotation_center<Rational>(exact, gen::RationalVec<3>::Zero());
  std::vector<Rational> weights;
  for (const double x : w) weights.push_back(Rational(x));
  const auto v = blend_spherical<Rational>(exact, weights, convert<Rational>(node.reference.center));
  const double distance = std::sqrt(CGAL::to_double(squared_distance<Rational, 3>(v, convert<Rational>(ball.center))));
  return {norm(blend_quaternion<double>(palette[0], w)), (distance - ball.radius) / node.reference.center.norm()};
}

}  // namespace

PROPTEST(algorithm1_repaired) {
  t.holds("the ball encloses every vertex of S with admissible weights",
          {.form = "repaired",
           .number_type = "interval to exact",
           .cases = 2000,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"mostly by intervals of doubles", 0.5}, {"decided exactly", 0.5}}},
          [] { check_theorem<MeanBalls>(oracle::Gather::at_mean); });
  t.holds("whatever centers the balls are given, the ball encloses every vertex of S with admissible weights",
          {.form = "repaired",
           .number_type = "interval to exact",
           .cases = 1000,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"decided exactly", 1}}},
          [] { check_theorem<FirstPoints>(oracle::Gather::at_first); });
  t.holds("intervals hold the ball of the squared form, or miss no point of it where they fall back on all rotations",
          {.number_type = "interval", .cases = 1000, .degenerate_at_least = 0.2, .degenerate_at_most = 0.5}, [] {
            const RefitCase c = *gen::refit_case(gen::Turns::any);
            classify(c);
            const auto exact = oracle::repaired_ball(c, oracle::Gather::at_first);
            const auto ball = Repaired<FirstPoints>{}(gen::NodeOf<MultiprecisionInterval>(c).node());
            MultiprecisionInterval radius(0);
            for (const auto& reach : exact->reaches)
              radius = max_of<MultiprecisionInterval>(radius, root(lift<MultiprecisionInterval>(reach.squared_distance)) +
                                                                  root(lift<MultiprecisionInterval>(reach.squared_radius)));
            const Ball3<MultiprecisionInterval> expected{lift<MultiprecisionInterval>(exact->center),
                                                         radius + lift<MultiprecisionInterval>(exact->extra)};
            Verdict same = equal(ball.radius, expected.radius);
            for (int i = 0; i < 3; ++i) same &= equal(ball.center[i], expected.center[i]);
            RC_ASSERT(same != Verdict::fails || encloses(ball, expected) != Verdict::fails);
          });
  t.holds("in double with mean balls it misses no exactly skinned vertex by more than 1e-12 of the coordinates' size",
          {.number_type = "double", .cases = 2000}, [] { check_double<MeanBalls>(); });
  t.holds("in double with smallest balls it misses no exactly skinned vertex by more than 1e-12 of the coordinates' size",
          {.number_type = "double", .cases = 2000}, [] { check_double<SmallestBalls>(); });
  t.example(
      "in double the miss is a few ulps over the length of the shortest blend, far more than 1e-12 where that all but "
      "vanishes",
      {.number_type = "double"}, [] {
        bool bounded = true;
        double shortest = 1, worst = 0;
        for (int off = 1; off < 2000; ++off) {
          const auto [length, miss] = miss_of_short_blend(off);
          bounded = bounded && miss <= 1e-15 / length;
          if (miss > worst) worst = miss, shortest = length;
        }
        char text[100];
        std::snprintf(text, sizeof text, "a blend of length %.1e misses by %.1e of ||p - r_c||", shortest, worst);
        return Checked(bounded && worst > 1e-12, 1999, text);
      });
}

}  // namespace proptests::suite_algorithm1_repaired
