// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s44_sum_of_bounds.hpp"

#include "lemmas/s42_linear_part_hull.hpp"
#include "proptests/counterexamples/s44_sum_of_bounds.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_s44_sum_of_bounds {
namespace {

using namespace refitlab;
using Point = Vec<Rational, 3>;

Rational any_radius() { return *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::positive_rational(), gen::positive_rational()); }

// Draws a point of the ball [0, radius], often of its boundary.
Point point_within(const Rational& radius) { return *gen::sphere_point<3>() * (radius * *gen::unit_interval_rational()); }

s44_sum::Case any_case() {
  s44_sum::Case c;
  c.bounds = {*gen::vectors<3>(1, 5), {*gen::rational_vector<3>(), any_radius()}, any_radius()};
  c.parts = {*gen::convex_weights(static_cast<int>(c.bounds.linear.size())),
             c.bounds.spherical.center + point_within(c.bounds.spherical.radius), point_within(c.bounds.inflation)};
  // The ball is about one of the points or any point, and as small as it can be.
  c.ball.center =
      *rc::gen::arbitrary<bool>() ? Point(c.bounds.linear[0] + c.bounds.spherical.center) : *gen::rational_vector<3>();
  Rational farthest(0);
  for (const Point& r : c.bounds.linear)
    farthest = max_of(farthest, squared_distance<Rational, 3>(r + c.bounds.spherical.center, c.ball.center));
  c.ball.radius = upper_root(farthest) + c.bounds.spherical.radius;
  return c;
}

bool is_degenerate(const s44_sum::Case& c) {
  return c.bounds.linear.size() == 1 || c.bounds.linear.front() == c.bounds.linear.back() || c.bounds.inflation == 0 ||
         c.bounds.spherical.radius == 0;
}

// Draws three or four points, so that there is one between the first and the last, with F, r and a ball around it all.
s44_sum::Case several_points() {
  s44_sum::Case c;
  const int m = *rc::gen::element(3, 4).as("points");
  c.bounds.linear = *rc::gen::container<std::vector<Point>>(static_cast<std::size_t>(m), gen::rational_vector<3>());
  c.bounds.spherical = {*gen::rational_vector<3>(), any_radius()};
  c.bounds.inflation = any_radius();
  c.parts = {*gen::convex_weights(m), c.bounds.spherical.center + point_within(c.bounds.spherical.radius),
             point_within(c.bounds.inflation)};
  c.ball.center = *gen::rational_vector<3>();
  for (const Point& r : c.bounds.linear)
    c.ball.radius =
        max_of(c.ball.radius, upper_root(squared_distance<Rational, 3>(r + c.bounds.spherical.center, c.ball.center)));
  c.ball.radius += c.bounds.spherical.radius;
  return c;
}

Weakening of(const s44_sum::Case& c) {
  return {sum_of_bounds_hypotheses(c.ball, c.bounds, c.parts), sum_of_bounds(c.ball, c.bounds, c.parts).verdict};
}

// Puts all of the weight on one of the points.
void lean_on(s44_sum::Case& c, std::size_t k) {
  c.parts.coefficients.assign(c.bounds.linear.size(), Rational(0));
  c.parts.coefficients[k] = 1;
}

void hypotheses_need_each_part(Suite& t) {
  t.holds("parts of exactly their bounds, and a ball that touches all of one ball, meet the hypotheses",
          {.number_type = "rational"}, [] {
            auto c = several_points();
            RC_ASSERT(of(c).hypothesis == Verdict::holds);
            c.parts.spherical = c.bounds.spherical.center + *gen::sphere_point<3>() * c.bounds.spherical.radius;
            c.parts.offset = *gen::sphere_point<3>() * c.bounds.inflation;
            RC_ASSERT(of(c).hypothesis == Verdict::holds && of(c).conclusion == Verdict::holds);
            c.bounds.linear.assign(3, c.ball.center - c.bounds.spherical.center + *gen::sphere_point<3>());
            lean_on(c, 0);
            c.ball.radius = c.bounds.spherical.radius + Rational(1);
            RC_ASSERT(of(c).hypothesis == Verdict::holds && of(c).conclusion == Verdict::holds);
          });
  needs_part(t, "one of the equal balls is not in the ball, the others are", [] {
    auto c = several_points();
    const auto k = *rc::gen::inRange<std::size_t>(0, c.bounds.linear.size()).as("which");
    const Point way = *gen::sphere_point<3>();
    const Rational amount = *gen::positive_rational().as("amount");
    // Its center is in the ball or not.
    c.bounds.linear[k] = c.ball.center - c.bounds.spherical.center + way * (c.ball.radius - c.bounds.spherical.radius + amount);
    RC_ASSERT(encloses_equal_balls(c.ball, c.bounds) == Verdict::fails);
    lean_on(c, k);
    c.parts.spherical = c.bounds.spherical.center + way * c.bounds.spherical.radius;
    c.parts.offset = way * c.bounds.inflation;
    return of(c);
  });
  needs_part(t, "the ball is no smaller than F", [] {
    auto c = several_points();
    c.bounds.linear.assign(3, c.ball.center - c.bounds.spherical.center);
    lean_on(c, 0);
    const Rational amount = *gen::positive_rational().as("amount");
    const Point way = *gen::sphere_point<3>();
    c.bounds.spherical.radius = c.ball.radius + amount;
    c.parts.spherical = c.bounds.spherical.center + way * c.bounds.spherical.radius;
    c.parts.offset = way * c.bounds.inflation;
    return of(c);
  });
  needs_part(t, "the coefficients are convex: none is below 0, and they sum to 1", [] {
    auto c = several_points();
    const auto m = c.parts.coefficients.size(), k = *rc::gen::inRange<std::size_t>(0, m).as("which");
    const Rational amount = *gen::positive_rational().as("amount");
    if (*rc::gen::arbitrary<bool>().as("keeps the sum"))
      c.parts.coefficients[(k + 1) % m] += c.parts.coefficients[k] + amount, c.parts.coefficients[k] = -amount;
    else c.parts.coefficients[k] += amount;
    return of(c);
  });
  t.holds("a coefficient more or less than there are points is refused", {.number_type = "rational"}, [] {
    const auto c = several_points();
    auto fewer = c, more = c;
    fewer.parts.coefficients.assign(c.bounds.linear.size() - 1, Rational(0));
    fewer.parts.coefficients[0] = 1;
    more.parts.coefficients.push_back(Rational(0));
    RC_ASSERT(of(c).hypothesis == Verdict::holds);
    RC_ASSERT(sum_of_bounds_hypotheses(c.ball, c.bounds, fewer.parts) == Verdict::fails);
    RC_ASSERT(sum_of_bounds_hypotheses(c.ball, c.bounds, more.parts) == Verdict::fails);
    RC_ASSERT(encloses_equal_balls<Rational>(c.ball, {{}, c.bounds.spherical, c.bounds.inflation}) == Verdict::fails);
  });
}

void radii_and_offsets_need_each_part(Suite& t) {
  needs_part(t, "the spherical part is in F", [] {
    auto c = several_points();
    c.parts.spherical = c.bounds.spherical.center +
                        *gen::sphere_point<3>() * (c.bounds.spherical.radius + *gen::positive_rational().as("amount"));
    return of(c);
  });
  needs_part(t, "the offset is at most r", [] {
    auto c = several_points();
    c.parts.offset = *gen::sphere_point<3>() * (c.bounds.inflation + *gen::positive_rational().as("amount"));
    return of(c);
  });
  needs_part(t, "r is not negative", [] {
    auto c = several_points();
    RC_PRE(c.bounds.inflation > 0);
    // Its square is as large.
    c.bounds.inflation = -c.bounds.inflation;
    RC_ASSERT(parts_are_bounded(c.bounds, c.parts) == Verdict::holds);
    return of(c);
  });
  t.holds("F's radius is not negative", {.number_type = "rational"}, [] {
    auto c = several_points();
    RC_PRE(c.bounds.spherical.radius > 0);
    c.bounds.spherical.radius = -c.bounds.spherical.radius;
    RC_ASSERT(encloses_equal_balls(c.ball, c.bounds) == Verdict::holds);
    RC_ASSERT(parts_are_bounded(c.bounds, c.parts) == Verdict::fails);
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.example("intervals decide that a ball touches another from inside, but not where its farthest point is", {}, [] {
    const Vec<Interval, 3> origin(Interval(0), Interval(0), Interval(0)), center(Interval(3), Interval(4), Interval(0));
    const Ball3<Interval> outer{origin, Interval(6)}, inner{center, Interval(1)};
    return encloses(outer, inner) == Verdict::holds && farthest_point_decides(outer, inner) == Verdict::undecided;
  });
  t.holds("short enough steps that end elsewhere in one coordinate are rejected", {.number_type = "rational"}, [] {
    auto c = several_points();
    const auto sum = sum_of_bounds(c.ball, c.bounds, c.parts);
    RC_ASSERT(is_sum_steps(c.ball, c.bounds, sum.vertex, sum.steps) == Verdict::holds);
    Point elsewhere = sum.vertex;
    const Rational amount = *gen::positive_rational().as("amount");
    elsewhere[*rc::gen::inRange(0, 3)] += *rc::gen::element(amount, Rational(-amount));
    RC_ASSERT(is_sum_steps(c.ball, c.bounds, elsewhere, sum.steps) == Verdict::fails);
  });
  t.holds("steps of a ball that is smaller than F are rejected", {.number_type = "rational"}, [] {
    auto c = several_points();
    const Rational amount = *gen::positive_rational().as("amount");
    c.bounds.spherical.radius = c.ball.radius;
    const SumSteps<Rational> rest{Point::Zero(), Point::Zero(), Point::Zero()};
    RC_ASSERT(is_sum_steps(c.ball, c.bounds, c.ball.center, rest) == Verdict::holds);
    c.bounds.spherical.radius += amount;
    RC_ASSERT(is_sum_steps(c.ball, c.bounds, c.ball.center, rest) == Verdict::fails);
  });
  t.holds(
      "a sum is in the inflated ball up to its surface, and a hull of balls in the sum up to F's", {.number_type = "rational"},
      [] {
        auto c = several_points();
        const Rational amount = *gen::positive_rational().as("amount");
        const Point way = *gen::sphere_point<3>();
        const Point to_surface = way * (c.ball.radius + c.bounds.inflation);
        c.parts.spherical = Point::Zero();
        c.parts.offset = c.ball.center + to_surface - combine<Rational, 3>(c.parts.coefficients, c.bounds.linear);
        RC_ASSERT(of(c).conclusion == Verdict::holds);
        c.parts.offset += way * amount;
        RC_ASSERT(of(c).conclusion == Verdict::fails);
        for (const bool beyond : {false, true}) {
          std::vector<Point> points;
          for (const Point& r : c.bounds.linear)
            points.push_back(r + c.bounds.spherical.center + way * (c.bounds.spherical.radius + (beyond ? amount : Rational(0))));
          RC_ASSERT(hull_of_balls_in_sum<Rational>(c.bounds, points, c.parts.coefficients).verdict == verdict_of(!beyond));
        }
      });
  t.holds("a ball encloses another, about the same center too, as its farthest point says",
          {.number_type = "exact root", .cases = 100}, [] {
            const Point center = *gen::rational_vector<3>();
            const Rational inner = any_radius(), outer = any_radius();
            const auto small = lift<ExactRoot>(Ball3<Rational>{center, inner}),
                       large = lift<ExactRoot>(Ball3<Rational>{center, outer});
            RC_ASSERT(encloses(large, farthest_point(small, large.center)) == verdict_of(inner <= outer));
            RC_ASSERT(squared_distance(farthest_point(small, large.center), small.center) == lift<ExactRoot>(sq(inner)));
          });
}

void inflated_balls_enclose_every_sum(Suite& t) {
  t.holds("a ball of the equal balls r'_k + F, inflated by r, encloses every sum of the parts",
          {.form = "printed", .number_type = "rational", .degenerate_at_least = 0.3, .degenerate_at_most = 0.9}, [] {
            const auto c = any_case();
            RC_CLASSIFY(is_degenerate(c), "degenerate");
            RC_ASSERT(sum_of_bounds_hypotheses(c.ball, c.bounds, c.parts) == Verdict::holds);
            const auto sum = sum_of_bounds(c.ball, c.bounds, c.parts);
            RC_ASSERT(sum.verdict == Verdict::holds);
            RC_ASSERT(is_sum_steps(c.ball, c.bounds, sum.vertex, sum.steps) == Verdict::holds);
          });
  t.holds("the hull of the balls r'_k + F is the hull of the r'_k plus F: nothing is lost",
          {.form = "printed", .number_type = "rational", .degenerate_at_least = 0.3, .degenerate_at_most = 0.9}, [] {
            const auto c = any_case();
            RC_CLASSIFY(is_degenerate(c), "degenerate");
            std::vector<Point> points;
            for (const Point& r : c.bounds.linear)
              points.push_back(r + c.bounds.spherical.center + point_within(c.bounds.spherical.radius));
            const auto hull = hull_of_balls_in_sum<Rational>(c.bounds, points, c.parts.coefficients);
            RC_ASSERT(hull.verdict == Verdict::holds);
            RC_ASSERT((is_hull_point<Rational, 3>(c.bounds.linear, hull.linear, c.parts.coefficients) == Verdict::holds));
            RC_ASSERT((is_hull_point<Rational, 3>(points, hull.linear + hull.spherical, c.parts.coefficients) == Verdict::holds));
          });
  t.holds("a ball encloses another if and only if it encloses its farthest point",
          {.form = "printed", .number_type = "exact root", .cases = 200, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9},
          [] {
            const Ball3<Rational> inner{*gen::rational_vector<3>(), any_radius()};
            Ball3<Rational> outer{*rc::gen::oneOf(rc::gen::just(inner.center), gen::rational_vector<3>()), any_radius()};
            // They touch if the distance is rational, and nearly so otherwise.
            if (*rc::gen::arbitrary<bool>())
              outer.radius = inner.radius + upper_root(squared_distance(inner.center, outer.center));
            RC_CLASSIFY(inner.radius == 0 || inner.center == outer.center, "degenerate");
            const auto decides = [](const auto& o, const auto& i) { return farthest_point_decides(o, i); };
            RC_ASSERT(decide_by_all<ExactRoot>(decides, outer, inner) == Verdict::holds);
          });
  t.example("the farthest vertex of a segment of balls is on the boundary of the inflated ball", {}, [] {
    const auto& c = s44_sum::extreme;
    const auto sum = sum_of_bounds(c.ball, c.bounds, c.parts);
    return sum_of_bounds_hypotheses(c.ball, c.bounds, c.parts) == Verdict::holds && sum.verdict == Verdict::holds &&
           squared_distance(sum.vertex, c.ball.center) == sq(Rational(c.ball.radius + c.bounds.inflation));
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 400}, [] {
    auto c = any_case();
    // This statement may fail.
    if (*rc::gen::arbitrary<bool>()) c.parts.offset *= Rational(3);
    decide_by_all(
        []<class S>(const Ball3<S>& ball, const std::vector<Vec<S, 3>>& linear, const Ball3<S>& spherical, const S& r,
                    const std::vector<S>& u, const Vec<S, 3>& s, const Vec<S, 3>& y) {
          return sum_of_bounds<S>(ball, {linear, spherical, r}, {u, s, y}).verdict;
        },
        c.ball, c.bounds.linear, c.bounds.spherical, c.bounds.inflation, c.parts.coefficients, c.parts.spherical, c.parts.offset);
    decide_by_all(
        []<class S>(const Ball3<S>& ball, const std::vector<Vec<S, 3>>& linear, const Ball3<S>& spherical) {
          return encloses_equal_balls<S>(ball, {linear, spherical, S(0)});
        },
        c.ball, c.bounds.linear, c.bounds.spherical);
  });

  t.holds("mutated steps are rejected", {.number_type = "rational", .cases = 400}, [] {
    const auto c = any_case();
    const auto sum = sum_of_bounds(c.ball, c.bounds, c.parts);
    const auto rejected = [&](const SumSteps<Rational>& s) {
      return is_sum_steps(c.ball, c.bounds, sum.vertex, s) == Verdict::fails;
    };
    const Point bump = *gen::nonzero_vector<3>();
    auto center = sum.steps, spherical = sum.steps, offset = sum.steps;
    center.to_center += bump;
    spherical.to_spherical -= bump;
    offset.to_offset += bump;
    RC_ASSERT(rejected(center) && rejected(spherical) && rejected(offset));
    // The sum is right by steps that are too long, one pair at a time.
    const Rational far = 2 * (c.ball.radius + c.bounds.inflation) + 1;
    const Point leap = *gen::sphere_point<3>() * far;
    auto first = sum.steps, second = sum.steps, third = sum.steps;
    first.to_center += leap, first.to_offset -= leap;
    second.to_spherical += leap, second.to_center -= leap;
    third.to_offset += leap, third.to_spherical -= leap;
    RC_ASSERT(rejected(first) && rejected(second) && rejected(third));
  });
  t.holds("one step from the center may be as long as its own bound, and no longer", {.number_type = "rational", .cases = 400},
          [] {
            const auto c = any_case();
            const Rational amount = *gen::positive_rational(), s = c.bounds.spherical.radius;
            const Point way = *gen::sphere_point<3>(), rest = Point::Zero();
            const auto alone = [&](int step, const Rational& length) {
              const Point to = way * length;
              const SumSteps<Rational> steps{step == 0 ? to : rest, step == 1 ? to : rest, step == 2 ? to : rest};
              return is_sum_steps<Rational>(c.ball, c.bounds, c.ball.center + to, steps);
            };
            const Rational limits[] = {c.ball.radius - s, s, c.bounds.inflation};
            for (int step = 0; step < 3; ++step) {
              RC_ASSERT(alone(step, limits[step]) == Verdict::holds);
              RC_ASSERT(alone(step, limits[step] + amount) == Verdict::fails);
            }
          });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const s44_sum::Case& c) {
    t.example(sentence, {.form = "printed", .hypothesis = hypothesis}, [&] {
      return sum_of_bounds_hypotheses(c.ball, c.bounds, c.parts) == Verdict::fails &&
             sum_of_bounds(c.ball, c.bounds, c.parts).verdict == Verdict::fails;
    });
  };
  fails_without("the coefficients are convex", "beyond the hull a sum leaves the ball", s44_sum::not_convex);
  fails_without("the spherical part is in F", "beyond F a sum leaves the ball", s44_sum::spherical_outside);
  fails_without("the offset is at most r", "beyond r a sum leaves the ball", s44_sum::offset_too_long);
  fails_without("the ball encloses balls, not only their centers", "a ball of the centers is too small", s44_sum::ball_of_points);
  fails_without("the ball encloses every ball", "a ball of the first ball misses the second", s44_sum::ball_of_one);
  fails_without("the ball encloses every ball", "a ball of the second ball misses the first", s44_sum::ball_of_other);
}

PROPTEST(s44_sum_of_bounds) {
  hypotheses_need_each_part(t);
  radii_and_offsets_need_each_part(t);
  checks_need_each_part(t);
  inflated_balls_enclose_every_sum(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s44_sum_of_bounds
