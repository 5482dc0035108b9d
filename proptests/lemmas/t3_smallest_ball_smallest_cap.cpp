// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/t3_smallest_ball_smallest_cap.hpp"

#include "proptests/counterexamples/t3_smallest_ball_smallest_cap.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/nearest_point.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_t3_smallest_ball_smallest_cap {
namespace {

using namespace refitlab;

// Draws units with 0 outside their hull, mostly on one side of a plane, and the coefficients of the hull's nearest point.
template <int D>
struct UnitsOnOneSide {
  std::vector<Vec<Rational, D>> units = *gen::sphere_points<D>(1, 5);
  std::vector<Rational> coefficients;

  UnitsOnOneSide() {
    const Vec<Rational, D> side = *gen::nonzero_vector<D>();
    for (auto& n : units)
      if (dot(n, side) < 0) n = -n;
    coefficients = nearest_point_coefficients<D>(units);
    RC_PRE(squared_norm(combine<Rational, D>(coefficients, units)) != 0);
    int support = 0;
    for (const auto& u : coefficients) support += u != 0;
    RC_CLASSIFY(support == 1 || units.front() == units.back(), "degenerate");
    RC_CLASSIFY(support > 2, "a support of more than two");
  }
  auto cap() const { return smallest_cap<Rational, D>(units, coefficients); }
};

void nearest_point_makes_both(Suite& t) {
  t.holds(
      "the ball about the hull's nearest point has the certificate of the smallest ball, and its distance is ||c||",
      {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1}, [] {
        gen::for_some_dimension<2, 4>([](auto d) {
          const UnitsOnOneSide<d()> c;
          RC_ASSERT((smallest_cap_hypotheses<Rational, d()>(c.units, c.coefficients) == Verdict::holds));
          const auto cap = c.cap();
          RC_ASSERT(cap.verdict == Verdict::holds);
          RC_ASSERT(cap.squared_radius + cap.squared_distance == Rational(1));
          RC_ASSERT((is_smallest_ball<Rational, d()>(c.units, c.coefficients, cap.center, cap.squared_radius) == Verdict::holds));
        });
      });
  t.holds("no ball about another center and no cap about another apex is smaller",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1}, [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const UnitsOnOneSide<d()> c;
              const auto cap = c.cap();
              // The baseline is any one, or a close one.
              const Vec<Rational, d()> step = *gen::nonzero_vector<d()>();
              const Rational share = *rc::gen::element(Rational(1), Rational(1, 100), Rational(1, 10000));
              const Vec<Rational, d()> baseline = cap.center + step * share;
              RC_ASSERT((is_not_smaller_ball<Rational, d()>(c.units, cap, baseline) == Verdict::holds));
              RC_ASSERT((is_not_smaller_ball<Rational, d()>(c.units, cap, cap.center) == Verdict::holds));
              if (squared_norm(baseline) != 0)
                RC_ASSERT((is_not_smaller_cap<Rational, d()>(c.units, cap, baseline) == Verdict::holds));
            });
          });
  t.holds("a larger claim is not believed: some baseline is as small as the cap itself",
          {.number_type = "rational", .cases = 300}, [] {
            const UnitsOnOneSide<4> c;
            auto cap = c.cap();
            const Rational more = *gen::positive_rational();
            cap.squared_radius += more;
            RC_ASSERT((is_not_smaller_ball<Rational, 4>(c.units, cap, cap.center) == Verdict::fails));
            const Rational distance2 = cap.squared_distance;
            cap.squared_distance -= distance2 / (more + 1);
            RC_ASSERT((is_not_smaller_cap<Rational, 4>(c.units, cap, cap.center) == Verdict::fails));
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const UnitsOnOneSide<4> c;
    const Vec<Rational, 4> baseline = c.cap().center + *gen::rational_vector<4>();
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 4>>& n, const std::vector<S>& u) { return smallest_cap<S, 4>(n, u).verdict; },
        c.units, c.coefficients);
    decide_by_all([]<class S>(const std::vector<Vec<S, 4>>& n, const std::vector<S>& u,
                              const Vec<S, 4>& g) { return is_not_smaller_ball<S, 4>(n, smallest_cap<S, 4>(n, u), g); },
                  c.units, c.coefficients, baseline);
  });

  t.holds("a mutated certificate is rejected", {.number_type = "rational", .cases = 300}, [] {
    const UnitsOnOneSide<3> c;
    const auto cap = c.cap();
    const auto rejected = [&](const std::vector<Rational>& u, const Vec<Rational, 3>& center, const Rational& r2) {
      return is_smallest_ball<Rational, 3>(c.units, u, center, r2) == Verdict::fails;
    };
    const Rational bump = *gen::positive_rational();
    auto coefficients = c.coefficients;
    coefficients[0] += bump;
    Vec<Rational, 3> moved = cap.center;
    moved[*rc::gen::inRange(0, 3)] += bump;
    RC_ASSERT(rejected(coefficients, cap.center, cap.squared_radius));
    RC_ASSERT(rejected(c.coefficients, moved, cap.squared_radius));
    RC_ASSERT(rejected(c.coefficients, cap.center, cap.squared_radius + bump));
    RC_ASSERT(rejected(c.coefficients, cap.center, cap.squared_radius - bump));
    // Another convex combination has a ball about it that encloses, but its support is not on the boundary.
    const auto other = *gen::convex_weights(static_cast<int>(c.units.size()));
    const Vec<Rational, 3> center = combine<Rational, 3>(other, c.units);
    if (center != cap.center) {
      Rational r2(0);
      for (const auto& n : c.units) r2 = max_of(r2, squared_distance(n, center));
      RC_ASSERT(rejected(other, center, r2));
      RC_ASSERT((is_nearest_point<Rational, 3>(c.units, other) == Verdict::fails));
    }
  });

  t.example("a larger ball through both points, about 0, is not certified by their mean", {}, [] {
    const auto& c = t3_smallest::once;
    const t3_smallest::Point zero(0, 0), mean(Rational(1, 2), Rational(1, 2));
    return is_smallest_ball<Rational, 2>(c.units, c.coefficients, mean, Rational(1, 2)) == Verdict::holds &&
           is_smallest_ball<Rational, 2>(c.units, c.coefficients, zero, Rational(1)) == Verdict::fails;
  });
  t.example("a repeated point widens the cap of the mean, not the smallest cap", {}, [] {
    const auto mean_cosine = [](const std::vector<t3_smallest::Point>& units) {
      t3_smallest::Point sum(0, 0);
      for (const auto& n : units) sum += n;
      const auto distance = min_dot_distance<Rational, 2>(units, sum, Rational(0));
      return Rational(2 * sq(distance.least_dot) / squared_norm(sum) - 1);
    };
    const auto &once = t3_smallest::once, &twice = t3_smallest::twice;
    const auto cap = smallest_cap<Rational, 2>(once.units, once.coefficients);
    const auto repeated = smallest_cap<Rational, 2>(twice.units, twice.coefficients);
    return mean_cosine(once.units) == Rational(0) && mean_cosine(twice.units) == Rational(-3, 5) &&
           cap.verdict == Verdict::holds && repeated.verdict == Verdict::holds &&
           cap.squared_distance == repeated.squared_distance && cap.center == repeated.center;
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "each part of the hypotheses is looked at by itself", {.parts = 10, .share = 0.5},
      [] {
        UnitsOnOneSide<3> c;
        auto& units = c.units;
        auto& u = c.coefficients;
        const auto insert = [&](std::size_t k, const Vec<Rational, 3>& unit, const Rational& coefficient) {
          units.insert(units.begin() + static_cast<long>(k), unit);
          u.insert(u.begin() + static_cast<long>(k), coefficient);
        };
        const std::size_t k = gen::any_place(units.size() + 1), n = units.size() + 1;
        const Vec<Rational, 3> nearest = combine<Rational, 3>(u, units);
        std::string part;
        const std::size_t kind = gen::any_place(6);
        if (kind == 0) {
          part = gen::place(k, n) + " is no unit";
          insert(k, *gen::sphere_point<3>() * *rc::gen::element(Rational(2), Rational(1, 2), Rational(1001, 1000)), 0);
          u = nearest_point_coefficients<3>(units);
          RC_PRE(squared_norm(combine<Rational, 3>(u, units)) != 0);
        } else if (kind == 1) {
          part = gen::place(k, n) + " is on the near side";
          const Vec<Rational, 3> unit = *gen::sphere_point<3>();
          RC_PRE(dot(unit, nearest) < squared_norm(nearest));
          insert(k, unit, 0);
        } else if (kind == 2) {
          part = "a coefficient is negative, of a repeated point";
          const std::size_t i = gen::any_place(units.size());
          const Rational amount = *gen::excess();
          u[i] += amount;
          insert(k, units[i], -amount);
        } else if (kind == 3) {
          part = "the coefficients' sum is less than 1";
          const Rational rest = *rc::gen::element(Rational(1, 2), Rational(999, 1000));
          for (auto& x : u) x *= rest;
        } else if (kind == 4) {
          part = "0 is the nearest point";
          units.push_back(-units[0]);
          u.assign(units.size(), Rational(0));
          u.front() = u.back() = Rational(1, 2);
        } else {
          part = "there is not one coefficient a point";
          if (*rc::gen::arbitrary<bool>()) u.push_back(Rational(0));
          else units.push_back(units[0]);
        }
        const Verdict hypothesis = smallest_cap_hypotheses<Rational, 3>(units, u);
        // Nothing could be concluded from this, and the certificate must see it too.
        if (units.size() != u.size())
          return Weakening{part, hypothesis,
                           is_smallest_ball<Rational, 3>(units, u, nearest, Rational(1) - squared_norm(nearest))};
        return Weakening{part, hypothesis, smallest_cap<Rational, 3>(units, u).verdict};
      },
      1500);
}

void each_part_of_a_certificate_is_checked(Suite& t) {
  t.holds("the ball and the cap that are claimed are those of the formulas", {.number_type = "rational", .cases = 200}, [] {
    const UnitsOnOneSide<3> c;
    Vec<Rational, 3> center(0, 0, 0);
    for (std::size_t k = 0; k < c.units.size(); ++k) center += c.units[k] * c.coefficients[k];
    const Rational c2 = center.dot(center);
    const auto cap = c.cap();
    RC_ASSERT(cap.center == center && cap.squared_distance == c2 && cap.squared_radius == Rational(1) - c2);
  });
  t.holds("a ball about another point through the only one is not certified, whatever coordinate differs",
          {.number_type = "rational", .cases = 100}, [] {
            const std::vector<Vec<Rational, 3>> one{*gen::rational_vector<3>()};
            for (int i = 0; i < 3; ++i) {
              Vec<Rational, 3> center = one[0];
              center[i] += *gen::excess();
              const Rational r2 = squared_distance(one[0], center);
              RC_ASSERT((is_smallest_ball<Rational, 3>(one, std::vector<Rational>{1}, center, r2) == Verdict::fails));
            }
          });
  t.holds("each point has to be in the ball, and each of the support on its boundary", {.number_type = "rational", .cases = 300},
          [] {
            UnitsOnOneSide<3> c;
            const auto cap = c.cap();
            const std::size_t n = c.units.size() + 1, k = gen::any_place(n);
            const auto certified_with = [&](const Vec<Rational, 3>& point, const Rational& coefficient) {
              auto points = c.units;
              auto u = c.coefficients;
              points.insert(points.begin() + static_cast<long>(k), point);
              u.insert(u.begin() + static_cast<long>(k), coefficient);
              return is_smallest_ball<Rational, 3>(points, u, cap.center, cap.squared_radius);
            };
            std::size_t support = 0;
            while (c.coefficients[support] == 0) ++support;
            const Vec<Rational, 3> direction = c.units[support] - cap.center;
            RC_ASSERT(certified_with(cap.center, 0) == Verdict::holds);
            if (squared_norm(direction) > 0) {
              RC_ASSERT(certified_with(cap.center + direction, 0) == Verdict::holds);
              const Rational stretch = Rational(1) + *gen::excess();
              RC_ASSERT(certified_with(cap.center + direction * stretch, 0) == Verdict::fails);
              // The center itself is a point of the support: the combination is as before, but that point is not on the boundary.
              for (auto& x : c.coefficients) x /= 2;
              RC_ASSERT(certified_with(cap.center, Rational(1, 2)) == Verdict::fails);
            }
            const std::vector<Vec<Rational, 3>> none;
            RC_ASSERT(
                (is_smallest_ball<Rational, 3>(none, std::vector<Rational>{}, cap.center, cap.squared_radius) == Verdict::fails));
            RC_ASSERT((is_nearest_point<Rational, 3>(none, std::vector<Rational>{}) == Verdict::fails));
          });
}

void comparisons_need_each_part(Suite& t) {
  t.holds(
      "whether a ball or a cap is not smaller is decided by the farthest unit, on both sides and at the edge",
      {.number_type = "rational", .cases = 400}, [] {
        const UnitsOnOneSide<3> c;
        const Vec<Rational, 3> baseline = *rc::gen::oneOf(gen::nonzero_vector<3>(), rc::gen::just(c.cap().center),
                                                          rc::gen::just(Vec<Rational, 3>(-c.cap().center)));
        Rational farthest(0), least = c.units[0].dot(baseline);
        for (const auto& n : c.units) {
          const Vec<Rational, 3> gap = n - baseline;
          farthest = std::max<Rational>(farthest, gap.dot(gap)), least = std::min<Rational>(least, n.dot(baseline));
        }
        auto claim = c.cap();
        const Rational excess = *gen::excess(), length2 = baseline.dot(baseline);
        claim.squared_radius = farthest + *rc::gen::element(Rational(0), excess, Rational(-excess));
        RC_ASSERT((is_not_smaller_ball<Rational, 3>(c.units, claim, baseline) == verdict_of(claim.squared_radius <= farthest)));
        claim.squared_distance = least * least / length2 + *rc::gen::element(Rational(0), excess, Rational(-excess));
        const bool expected = least <= 0 || least * least <= claim.squared_distance * length2;
        RC_ASSERT((is_not_smaller_cap<Rational, 3>(c.units, claim, baseline) == verdict_of(expected)));
      });
  t.example("a certified ball along the way to 0 has no right angle to it: its least dot product is not ||c||^2", {}, [] {
    const std::vector<t3_smallest::Point> along{t3_smallest::Point(Rational(7, 5), 0), t3_smallest::Point(Rational(-1, 5), 0)};
    const std::vector<Rational> halves{Rational(1, 2), Rational(1, 2)};
    return is_smallest_ball<Rational, 2>(along, halves, t3_smallest::Point(Rational(3, 5), 0), Rational(16, 25)) ==
               Verdict::holds &&
           smallest_cap<Rational, 2>(along, halves).verdict == Verdict::fails;
  });
  t.example("a repeated unit with coefficients 2 and -1 makes no certificate", {}, [] {
    const std::vector<t3_smallest::Point> twice{t3_smallest::x, t3_smallest::x};
    return smallest_cap<Rational, 2>(twice, std::vector<Rational>{2, -1}).verdict == Verdict::fails;
  });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const t3_smallest::Case& c) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      return smallest_cap_hypotheses<Rational, 2>(c.units, c.coefficients) == Verdict::fails &&
             smallest_cap<Rational, 2>(c.units, c.coefficients).verdict == Verdict::fails;
    });
  };
  fails_without("the points are units", "for points of different lengths the nearest point is no center", t3_smallest::not_units);
  fails_without("c is the nearest point", "about another point of the hull the ball is not the smallest",
                t3_smallest::not_nearest);
  fails_without("0 is not in the hull", "if 0 is in the hull the nearest point is no direction", t3_smallest::zero_inside);
}

PROPTEST(t3_smallest_ball_smallest_cap) {
  nearest_point_makes_both(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  each_part_of_a_certificate_is_checked(t);
  comparisons_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_t3_smallest_ball_smallest_cap
