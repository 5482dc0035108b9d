// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/t3_min_dot_distance.hpp"

#include "proptests/counterexamples/t3_min_dot_distance.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_t3_min_dot_distance {
namespace {

using namespace refitlab;

// Draws units, a center that is one of them, their mean or any point but 0, and the largest squared distance.
template <int D>
struct UnitsAndCenter {
  std::vector<Vec<Rational, D>> units = *gen::sphere_points<D>(1, 6);
  Vec<Rational, D> center = *rc::gen::oneOf(rc::gen::just(units[0]), rc::gen::just(mean()), gen::nonzero_vector<D>());
  Rational squared_radius = squared_distance(units[0], center);

  UnitsAndCenter() {
    for (const auto& n : units) squared_radius = max_of(squared_radius, squared_distance(n, center));
    RC_CLASSIFY(units.size() == 1 || units.front() == units.back() || squared_radius == 0, "degenerate");
  }
  auto distance() const { return min_dot_distance<Rational, D>(units, center, squared_radius); }

 private:
  Vec<Rational, D> mean() const {
    Vec<Rational, D> sum = Vec<Rational, D>::Zero();
    for (const auto& n : units) sum += n;
    return sum == Vec<Rational, D>::Zero() ? units[0] : Vec<Rational, D>(sum / Rational(static_cast<int>(units.size())));
  }
};

void distance_is_the_least_dot_product(Suite& t) {
  t.holds("d_H is the least dot product of a unit with the direction of the center",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const UnitsAndCenter<d()> c;
              RC_ASSERT((min_dot_distance_hypotheses<Rational, d()>(c.units, c.center, c.squared_radius) == Verdict::holds));
              const auto distance = c.distance();
              RC_ASSERT(distance.verdict == Verdict::holds);
              RC_ASSERT((is_least_dot<Rational, d()>(c.units, c.center, distance) == Verdict::holds));
            });
          });
  t.holds("for any larger radius the direct form is not looser",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            UnitsAndCenter<4> c;
            c.squared_radius += *gen::unit_interval_rational();
            RC_ASSERT(c.distance().not_looser == Verdict::holds);
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 500}, [] {
    UnitsAndCenter<4> c;
    if (*rc::gen::arbitrary<bool>()) c.squared_radius += *gen::rational();
    decide_by_all([]<class S>(const std::vector<Vec<S, 4>>& n, const Vec<S, 4>& center,
                              const S& r2) { return min_dot_distance<S, 4>(n, center, r2).verdict; },
                  c.units, c.center, c.squared_radius);
    decide_by_all([]<class S>(const std::vector<Vec<S, 4>>& n, const Vec<S, 4>& center,
                              const S& r2) { return min_dot_distance<S, 4>(n, center, r2).not_looser; },
                  c.units, c.center, c.squared_radius);
  });

  t.holds("a mutated minimum is rejected", {.number_type = "rational", .cases = 500}, [] {
    const UnitsAndCenter<3> c;
    const auto rejected = [&](const MinDotDistance<Rational>& w) {
      return is_least_dot<Rational, 3>(c.units, c.center, w) == Verdict::fails;
    };
    auto less = c.distance(), more = less, beyond = less;
    less.least_dot -= *gen::positive_rational();
    more.least_dot += *gen::positive_rational();
    beyond.nearest = c.units.size();
    RC_ASSERT(rejected(less) && rejected(more) && rejected(beyond));
    // Another unit with its own dot product is rejected if that is not the least.
    for (std::size_t k = 0; k < c.units.size(); ++k) {
      auto other = c.distance();
      other.nearest = k;
      other.least_dot = dot(c.units[k], c.center);
      if (other.least_dot != c.distance().least_dot) RC_ASSERT(rejected(other));
    }
  });

  t.holds("each verdict is that of its inequality, on both sides and at its edge", {.number_type = "rational", .cases = 600}, [] {
    gen::for_some_dimension<2, 4>([](auto d) {
      UnitsAndCenter<d()> c;
      if (*rc::gen::inRange(0, 6) == 0) c.center.setZero(), c.squared_radius = 1;
      const bool is_center = squared_norm(c.center) != 0;
      const Rational largest = c.squared_radius, excess = *gen::excess();
      c.squared_radius += *rc::gen::element(Rational(0), excess, Rational(-excess));
      std::vector<Rational> dots;
      for (const auto& n : c.units) dots.push_back(n.dot(c.center));
      const auto found = c.distance();
      RC_ASSERT(found.least_dot == *std::min_element(dots.begin(), dots.end()));
      RC_ASSERT(dots.at(found.nearest) == found.least_dot);
      const bool is_largest = c.squared_radius == largest;
      RC_ASSERT(found.verdict == verdict_of(is_center && is_largest));
      RC_ASSERT(found.not_looser == verdict_of(c.squared_radius >= largest));
      RC_ASSERT((is_largest_distance<Rational, d()>(c.units, c.center, c.squared_radius) == verdict_of(is_largest)));
      RC_ASSERT((min_dot_distance_hypotheses<Rational, d()>(c.units, c.center, c.squared_radius) ==
                 verdict_of(is_center && is_largest)));
    });
  });
}

void hypotheses_and_minima_need_each_part(Suite& t) {
  needs_each_part(
      t, "each part of the hypotheses is looked at by itself", {.parts = 8, .share = 0.1},
      [] {
        auto units = *rc::gen::mapcat(rc::gen::inRange(3, 6), [](int m) {
          return rc::gen::container<std::vector<Vec<Rational, 3>>>(m, gen::sphere_point<3>());
        });
        const std::size_t n = units.size(), k = gen::any_place(n);
        Vec<Rational, 3> center = *gen::nonzero_vector<3>();
        const auto distance = [&](std::size_t i) { return squared_distance(units[i], center); };
        const auto farthest = [&] {
          std::size_t far = 0;
          for (std::size_t i = 1; i < n; ++i)
            if (distance(far) < distance(i)) far = i;
          return far;
        };
        std::string part;
        Rational r2;
        const std::size_t kind = gen::any_place(4);
        if (kind == 0) {
          part = gen::place(k, n) + " is no unit";
          units[k] *= *rc::gen::element(Rational(2), Rational(1, 2), Rational(1001, 1000), Rational(0));
          r2 = distance(farthest());
        } else if (kind == 1) {
          part = gen::place(k, n) + " is farther";
          std::swap(units[k], units[farthest()]);
          const Rational far = distance(k);
          r2 = 0;
          for (std::size_t i = 0; i < n; ++i)
            if (i != k) r2 = std::max<Rational>(r2, distance(i));
          RC_PRE(r2 < far);
        } else if (kind == 2) {
          part = "none is as far";
          r2 = distance(farthest()) + *gen::excess();
        } else {
          part = "the center is 0";
          center.setZero();
          r2 = 1;
        }
        return Weakening{part, min_dot_distance_hypotheses<Rational, 3>(units, center, r2),
                         min_dot_distance<Rational, 3>(units, center, r2).verdict};
      },
      1200);
  t.holds("a minimum of another unit is rejected", {.number_type = "rational", .cases = 300}, [] {
    const UnitsAndCenter<3> c;
    const auto good = c.distance();
    for (std::size_t k = 0; k < c.units.size(); ++k) {
      auto other = good;
      other.nearest = k;
      const bool attains = dot(c.units[k], c.center) == good.least_dot;
      RC_ASSERT((is_least_dot<Rational, 3>(c.units, c.center, other) == verdict_of(attains)));
    }
  });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const t3_dot::Case& c) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      return min_dot_distance_hypotheses<Rational, 2>(c.units, c.center, c.squared_radius) == Verdict::fails &&
             min_dot_distance<Rational, 2>(c.units, c.center, c.squared_radius).verdict == Verdict::fails;
    });
  };
  fails_without("the vectors are units", "for a vector of length 2 the two forms differ", t3_dot::not_unit);
  fails_without("r is at most the largest distance", "for a larger radius the paper's form is smaller", t3_dot::too_large);
  fails_without("r is at least the largest distance", "for a smaller radius the paper's form is larger", t3_dot::too_small);
  fails_without("r is that of the farthest unit", "the nearest unit's radius will not do", t3_dot::of_the_nearest);
  fails_without("c is not 0", "about 0 there is no distance", t3_dot::about_zero);
}

PROPTEST(t3_min_dot_distance) {
  distance_is_the_least_dot_product(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_and_minima_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_t3_min_dot_distance
