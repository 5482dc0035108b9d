// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s43_distance_range.hpp"

#include "proptests/counterexamples/s43_distance_range.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_s43_distance_range {
namespace {

using namespace refitlab;

// Draws a center at a rational distance from 0, and a radius of which a third touch the unit sphere from inside or outside.
template <int D>
struct BallAndSphere {
  Rational length = *gen::positive_rational();
  Vec<Rational, D> center = *gen::sphere_point<D>() * length;
  Rational radius = *rc::gen::oneOf(
      rc::gen::just(Rational(abs(length - 1))), gen::unit_interval_rational(),
      rc::gen::map(gen::unit_interval_rational(), [at = abs(length - 1)](const Rational& x) { return Rational(at + x); }));

  bool touches() const { return radius == abs(length - 1); }
};

// Compares each predicate with the inequality of its words, which can be read off as the norm of the center is known.
void predicates_say_their_words(Suite& t) {
  t.holds("every condition and the range are right up to their edges, and for a radius below 0",
          {.number_type = "rational", .cases = 3000}, [] {
            const Rational c =
                *rc::gen::weightedOneOf<Rational>(
                     {{1, rc::gen::just(Rational(0))}, {1, rc::gen::just(Rational(1))}, {4, gen::positive_rational()}})
                     .as("||c||");
            const Vec<Rational, 3> center = *gen::sphere_point<3>().as("direction") * c;
            const Rational near = c - 1, far = c + 1, zero(0), one(1);
            const Rational r =
                *rc::gen::oneOf(rc::gen::element(zero, one, near, Rational(-near), far, Rational(-far)), gen::rational())
                     .as("radius");
            // The square is also r^2 = 1 + c^2, which has no rational root.
            const Rational half = one + c * c;
            const Rational square = *rc::gen::element(Rational(r * r), half, Rational(half + 1), Rational(half / 2)).as("r^2");
            const Rational n = half - square;
            RC_ASSERT(scaled_distance(center, square) == n);
            RC_ASSERT(distance_is_in_range(center, square) == verdict_of(c > 0 && n >= 0 && n <= 2 * c));
            RC_ASSERT(is_at_most_half(center, square) == verdict_of(square <= half));
            if (r >= 0) {
              RC_ASSERT(reaches_surface_from_inside(center, r) == verdict_of(c + r >= 1));
              RC_ASSERT(reaches_surface_from_outside(center, r) == verdict_of(c - r <= 1));
            }
            const bool printed = r >= 0 && r < 1 && c + r >= 1;
            const bool repaired = c > 0 && r >= 0 && c + r >= 1 && c - r <= 1 && r * r <= half;
            const bool in_range = c > 0 && half - r * r >= 0 && half - r * r <= 2 * c;
            RC_CLASSIFY(repaired, "the hypotheses hold");
            RC_CLASSIFY(printed && !in_range, "refutes the printed range");
            RC_ASSERT(distance_range_hypotheses_printed(center, r) == verdict_of(printed));
            RC_ASSERT(distance_range_hypotheses_repaired(center, r) == verdict_of(repaired));
            RC_ASSERT(distance_range(center, r).verdict == verdict_of(in_range));
            // The factors are those of a triangle with a side of length r.
            if (r >= 0) RC_ASSERT(is_distance_range(center, r, distance_range(center, r)) == verdict_of(in_range));
            RC_ASSERT(distance_range_printed(center, r) == verdict_of(!printed || in_range));
            RC_ASSERT(distance_range_repaired(center, r) == Verdict::holds);
          });
}

// Draws a ball of at most half of the sphere that holds the unit vector x.
template <int D>
struct BallAndUnit {
  Vec<Rational, D> x = *gen::sphere_point<D>(), center = *gen::nonzero_vector<D>();
  Rational squared_radius = squared_distance(x, center);

  BallAndUnit() { RC_PRE(dot(x, center) >= 0); }  // squared_radius = 1 + c^2 - 2 (x, c)
  Verdict hypotheses() const { return distance_range_hypotheses_by_point(center, squared_radius, x); }
  Verdict conclusion() const { return distance_range_by_point(center, squared_radius, x); }
};

void hypotheses_by_point_need_each_part(Suite& t) {
  t.holds("a unit vector on the ball's surface, and a ball of exactly half of the sphere, meet the hypotheses",
          {.number_type = "rational"}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              BallAndUnit<d()> b;
              RC_ASSERT(b.hypotheses() == Verdict::holds && b.conclusion() == Verdict::holds);
              b.squared_radius = Rational(1) + squared_norm(b.center);
              RC_ASSERT(b.hypotheses() == Verdict::holds && b.conclusion() == Verdict::holds);
            });
          });
  needs_part(t, "c is not 0", [] {
    BallAndUnit<3> b;
    b.center = Vec<Rational, 3>::Zero();
    b.squared_radius = 1;
    return Weakening{b.hypotheses(), b.conclusion()};
  });
  needs_part(t, "x is a unit vector, no longer and no shorter", [] {
    BallAndUnit<3> b;
    const Rational factor = Rational(1) + *gen::positive_rational().as("factor");
    b.x = *rc::gen::arbitrary<bool>().as("longer") ? Vec<Rational, 3>(b.x * factor) : Vec<Rational, 3>(b.x / factor);
    b.squared_radius = squared_distance(b.x, b.center);
    RC_PRE(is_at_most_half(b.center, b.squared_radius) == Verdict::holds);
    return Weakening{b.hypotheses(), b.conclusion()};
  });
  needs_part(t, "x is in the ball", [] {
    BallAndUnit<3> b;
    b.squared_radius /= Rational(1) + *gen::positive_rational().as("factor");
    RC_PRE(b.squared_radius > 0);
    return Weakening{b.hypotheses(), b.conclusion()};
  });
  needs_part(t, "r^2 <= 1 + ||c||^2", [] {
    BallAndUnit<3> b;
    b.squared_radius = Rational(1) + squared_norm(b.center) + *gen::positive_rational().as("amount");
    return Weakening{b.hypotheses(), b.conclusion()};
  });
  t.holds("a vector is a witness of the range only if it is short enough and in the ball", {.number_type = "rational"}, [] {
    // For a ball about a unit vector u, with r = 1, N is 1, so the witness needs 1/2 <= (x, u) <= 1.
    const Vec<Rational, 3> u = *gen::sphere_point<3>(), x = u * *gen::rational();
    const Rational along = dot(x, u);
    RC_ASSERT(distance_range_by_point(u, Rational(1), x) == verdict_of(along >= Rational(1, 2) && along <= Rational(1)));
    for (const Rational& edge : {Rational(1, 2), Rational(1)})
      RC_ASSERT((distance_range_by_point<Rational, 3>(u, Rational(1), u * edge) == Verdict::holds));
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("factors of which one is below 0, or whose product is too small or too large, are rejected",
          {.number_type = "rational"}, [] {
            const BallAndSphere<3> b;
            RC_PRE(distance_range_hypotheses_repaired(b.center, b.radius) == Verdict::holds);
            const auto good = distance_range(b.center, b.radius);
            const Rational amount = *gen::positive_rational(), product = good.from_inside * good.from_outside;
            const auto verdict = [&](const Rational& outside, const Rational& inside) {
              return is_distance_range(b.center, b.radius, DistanceRange<Rational>{Verdict::holds, outside, inside});
            };
            RC_ASSERT(verdict(product + amount, 1) == Verdict::fails && verdict(1, product + amount) == Verdict::fails);
            if (product > 0) RC_ASSERT(verdict(product / (1 + amount), 1) == Verdict::fails);
            RC_ASSERT(verdict(product, 1) == Verdict::holds);
            // They touch, and one of the factors may be anything but negative.
            if (product == 0)
              RC_ASSERT(verdict(0, -amount) == Verdict::fails && verdict(-amount, 0) == Verdict::fails &&
                        verdict(0, amount) == Verdict::holds);
          });
}

void printed_range_is_refuted(Suite& t) {
  t.refuted("r < 1 and ||c|| + r >= 1 give a distance in [0, 1]", {.form = "implied", .number_type = "rational"}, [] {
    const BallAndSphere<2> b;
    RC_ASSERT(distance_range_printed(b.center, b.radius) == Verdict::holds);
  });
  t.example("a ball outside the unit circle refutes the printed range", {.form = "printed"}, [] {
    const auto& [center, radius, distance] = s43_range::outside;
    return distance_range_hypotheses_printed(center, radius) == Verdict::holds &&
           distance_range_printed(center, radius) == Verdict::fails &&
           distance_range_repaired(center, radius) == Verdict::holds && scaled_distance(center, sq(radius)) / 6 == distance;
  });
}

void repaired_range_holds(Suite& t) {
  t.holds("| ||c|| - 1 | <= r and r^2 <= 1 + ||c||^2 give a distance in [0, 1]",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const BallAndSphere<d()> b;
              RC_PRE(distance_range_hypotheses_repaired(b.center, b.radius) == Verdict::holds);
              RC_CLASSIFY(b.touches() || b.radius == 0 || b.length == 1, "degenerate");
              const auto range = distance_range(b.center, b.radius);
              RC_ASSERT(range.verdict == Verdict::holds);
              RC_ASSERT(is_distance_range(b.center, b.radius, range) == Verdict::holds);
              // The norm is known here, so that the distance itself is.
              const Rational distance = scaled_distance(b.center, sq(b.radius)) / (2 * b.length);
              RC_ASSERT(Rational(0) <= distance && distance <= Rational(1));
            });
          });
  t.holds("a distance in [0, 1] needs both conditions",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const BallAndSphere<3> b;
            RC_CLASSIFY(b.touches() || b.radius == 0 || b.length == 1, "degenerate");
            RC_ASSERT(distance_is_in_range(b.center, sq(b.radius)) == distance_range_hypotheses_repaired(b.center, b.radius));
          });
  t.holds("a ball that holds a unit vector and at most half of the sphere has a distance in [0, 1]",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const Vec<Rational, d()> center = *gen::nonzero_vector<d()>(), x = *gen::sphere_point<d()>();
              const Rational more = *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::unit_interval_rational());
              const Rational squared_radius = squared_distance(x, center) + more;
              RC_PRE(distance_range_hypotheses_by_point(center, squared_radius, x) == Verdict::holds);
              RC_CLASSIFY(more == 0 || center == x, "degenerate");
              RC_ASSERT(distance_range_by_point(center, squared_radius, x) == Verdict::holds);
            });
          });

  t.holds("the conditions on the norm, decided without it, are right where it is known", {.number_type = "rational"}, [] {
    const BallAndSphere<3> b;
    const Rational radius = *rc::gen::oneOf(rc::gen::just(b.radius), gen::positive_rational());
    RC_ASSERT(reaches_surface_from_inside(b.center, radius) == verdict_of(b.length + radius >= 1));
    RC_ASSERT(reaches_surface_from_outside(b.center, radius) == verdict_of(b.length - radius <= 1));
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 500}, [] {
    const BallAndSphere<4> b;
    decide_by_all([]<class S>(const Vec<S, 4>& c, const S& r) { return distance_range_repaired<S, 4>(c, r); }, b.center,
                  b.radius);
    decide_by_all([]<class S>(const Vec<S, 4>& c, const S& r) { return distance_range_printed<S, 4>(c, r); }, b.center, b.radius);
    // This is the range check on which arccos relies.
    decide_by_all([]<class S>(const Vec<S, 4>& c, const S& r) { return distance_is_in_range<S, 4>(c, sq(r)); }, b.center,
                  b.radius);
  });

  t.holds("a mutated factor of Heron's formula is rejected", {.number_type = "rational", .cases = 500}, [] {
    const BallAndSphere<3> b;
    RC_PRE(distance_range_hypotheses_repaired(b.center, b.radius) == Verdict::holds);
    const auto good = distance_range(b.center, b.radius);
    auto from_inside = good, from_outside = good, both = good;
    from_inside.from_inside += *gen::positive_rational();
    from_outside.from_outside += *gen::positive_rational();
    both.from_inside = -both.from_inside;
    both.from_outside = -both.from_outside;
    if (good.from_outside != 0) RC_ASSERT(is_distance_range(b.center, b.radius, from_inside) == Verdict::fails);
    if (good.from_inside != 0) RC_ASSERT(is_distance_range(b.center, b.radius, from_outside) == Verdict::fails);
    if (good.from_outside != 0 || good.from_inside != 0) RC_ASSERT(is_distance_range(b.center, b.radius, both) == Verdict::fails);
  });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const s43_range::Case& c) {
    t.example(sentence, {.form = "repaired", .hypothesis = hypothesis}, [&] {
      return distance_range_hypotheses_repaired(c.center, c.radius) == Verdict::fails &&
             distance_range(c.center, c.radius).verdict == Verdict::fails &&
             is_distance_range(c.center, c.radius, distance_range(c.center, c.radius)) == Verdict::fails &&
             scaled_distance(c.center, sq(c.radius)) == 2 * c.distance * c.center[0];
    });
  };
  fails_without("||c|| - r <= 1", "a ball outside the sphere has a distance above 1", s43_range::outside);
  fails_without("||c|| + r >= 1", "a ball strictly inside the sphere has a distance above 1", s43_range::inside);
  fails_without("r^2 <= 1 + ||c||^2", "a ball that holds more than half of the sphere has a negative distance",
                s43_range::past_half);
  fails_without("c is not 0", "a ball about 0 has no distance", s43_range::about_zero);
  t.example("a ball of exactly half of the sphere meets every hypothesis, and its distance is 0", {.form = "repaired"}, [] {
    const Vec<Rational, 2> center{Rational(3, 4), Rational(0)}, x{Rational(0), Rational(1)};
    const Rational radius(5, 4);  // r^2 = 1 + ||c||^2
    return distance_range_hypotheses_repaired(center, radius) == Verdict::holds &&
           distance_range_hypotheses_by_point(center, sq(radius), x) == Verdict::holds &&
           distance_range(center, radius).verdict == Verdict::holds && scaled_distance(center, sq(radius)) == 0;
  });
  t.example("a ball that holds a vector which is no unit vector may miss the sphere",
            {.form = "repaired", .hypothesis = "the point is a unit vector"}, [] {
              const auto& x = s43_range::not_unit;
              return less_equal(squared_distance(x, x), Rational(0)) == Verdict::holds &&
                     distance_range_hypotheses_by_point(x, Rational(0), x) == Verdict::fails &&
                     distance_range_by_point(x, Rational(0), x) == Verdict::fails;
            });
}

PROPTEST(s43_distance_range) {
  predicates_say_their_words(t);
  hypotheses_by_point_need_each_part(t);
  checks_need_each_part(t);
  printed_range_is_refuted(t);
  repaired_range_holds(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s43_distance_range
