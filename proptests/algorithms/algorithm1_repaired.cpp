// The theorem: the repaired Algorithm 1 encloses every vertex of S with admissible weights.
#include "algorithms/refit/algorithm1_repaired.hpp"

#include "proptests/gen/skinned_samples.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/refit_ladder.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using gen::Blending;
using gen::RefitCase;
using gen::Sample;

// A policy that shows that no choice of a center is unsound: the first of the points.
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
void check_theorem(oracle::Gather gather, oracle::RungTally& tally) {
  const RefitCase c = *gen::refit_case(gen::Turns::any);
  classify(c);
  oracle::RefitLadder ladder(c, Repaired<Policy>{}, oracle::repaired_ball(c, gather));
  const Point3 center = Repaired<Policy>{}(gen::NodeOf<double>(c).node()).center;
  int seen = 0;
  for (const Sample& sample : gen::samples(c, Blending::spherical, center)) {
    const auto v = gen::skinned(c, sample, Blending::spherical);
    if (!v) continue;
    ++seen;
    const Decision d = ladder.encloses(*v);
    tally.add(d);
    RC_ASSERT(d.verdict != Verdict::fails);
  }
  RC_PRE(seen > 0);
}

// How far the ball of double misses the exactly skinned vertices of the same doubles, relative to the coordinates.
struct Misses {
  long vertices = 0, missed = 0;
  double worst = 0;
};

template <class Policy>
void check_double(Misses& misses) {
  const RefitCase c = gen::rounded_to_double(*gen::refit_case(gen::Turns::any));
  const Ball3<double> ball = Repaired<Policy>{}(gen::NodeOf<double>(c).node());
  const Ball3<Rational> exact{{Rational(ball.center[0]), Rational(ball.center[1]), Rational(ball.center[2])}, Rational(ball.radius)};
  bool missed = false;
  for (const Sample& sample : gen::samples(c, Blending::spherical, ball.center)) {
    const auto v = gen::skinned(c, sample, Blending::spherical);
    if (!v) continue;
    ++misses.vertices;
    if (encloses(exact, *v) == Verdict::holds) continue;
    ++misses.missed;
    missed = true;
    const Rational beyond = squared_distance(*v, exact.center) - exact.radius * exact.radius;
    double size = ball.center.norm() + ball.radius;
    for (const auto& set : c.sets) size += lift<double>(set.pose.rotation_center).norm();
    const double relative = CGAL::to_double(beyond) / (ball.radius + std::sqrt(CGAL::to_double(squared_distance(*v, exact.center)))) / size;
    misses.worst = std::max(misses.worst, relative);
    RC_ASSERT(relative <= 1e-12);
  }
  RC_CLASSIFY(missed, "missed by rounding");
}

Checked report(const Misses& m) {
  char text[160];
  std::snprintf(text, sizeof text, "%ld of %ld vertices missed by rounding (%.1f %%), by at most %.1e of the coordinates' size",
                m.missed, m.vertices, 100.0 * double(m.missed) / double(m.vertices), m.worst);
  return Checked(m.worst <= 1e-12, m.vertices, text);
}

}  // namespace

PROPTEST(algorithm1_repaired) {
  static oracle::RungTally mean, first;
  static Misses mean_misses, smallest_misses;
  t.holds("the ball encloses every vertex of S with admissible weights",
          {.form = "repaired", .number_type = "interval to exact", .cases = 2000, .degenerate_at_least = 0.2},
          [] { check_theorem<MeanBalls>(oracle::Gather::at_mean, mean); });
  t.example("of its points, intervals of doubles decide most, and squared forms most of those on the surface", {}, [] {
    return Checked(mean.share("interval") > 0.6 && mean.share(oracle::RungTally::none) < 0.1, mean.total(), mean.text());
  });
  t.holds("whatever centers the balls are given, the ball encloses every vertex of S with admissible weights",
          {.form = "repaired", .number_type = "interval to exact", .cases = 1000, .degenerate_at_least = 0.2},
          [] { check_theorem<FirstPoints>(oracle::Gather::at_first, first); });
  t.example("with these centers every point is decided exactly", {}, [] {
    return Checked(first.share(oracle::RungTally::none) == 0, first.total(), first.text());
  });
  t.holds("intervals hold the ball of the squared form, or miss no point of it where they fall back on all rotations",
          {.number_type = "interval", .cases = 1000, .degenerate_at_least = 0.2}, [] {
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
          {.number_type = "double", .cases = 2000}, [] { check_double<MeanBalls>(mean_misses); });
  t.example("how often mean balls in double miss by rounding", {.number_type = "double"}, [] { return report(mean_misses); });
  t.holds("in double with smallest balls it misses no exactly skinned vertex by more than 1e-12 of the coordinates' size",
          {.number_type = "double", .cases = 2000}, [] { check_double<SmallestBalls>(smallest_misses); });
  t.example("how often smallest balls in double miss by rounding", {.number_type = "double"}, [] { return report(smallest_misses); });
}

}  // namespace proptests
