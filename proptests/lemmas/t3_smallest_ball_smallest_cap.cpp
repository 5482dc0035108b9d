#include "lemmas/t3_smallest_ball_smallest_cap.hpp"

#include "proptests/counterexamples/t3_smallest_ball_smallest_cap.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/nearest_point.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;

// Units with 0 outside their hull, mostly on one side of a plane, and the coefficients of the hull's nearest point.
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

PROPTEST(t3_smallest_ball_smallest_cap) {
  t.holds("the ball about the hull's nearest point has the certificate of the smallest ball, and its distance is ||c||",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1}, [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const UnitsOnOneSide<d()> c;
              RC_ASSERT((smallest_cap_hypotheses<Rational, d()>(c.units, c.coefficients) == Verdict::holds));
              const auto cap = c.cap();
              RC_ASSERT(cap.verdict == Verdict::holds);
              RC_ASSERT(cap.squared_radius + cap.squared_distance == Rational(1));
              RC_ASSERT((is_smallest_ball<Rational, d()>(c.units, c.coefficients, cap.center, cap.squared_radius) ==
                         Verdict::holds));
            });
          });
  t.holds("no ball about another center and no cap about another apex is smaller",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1}, [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const UnitsOnOneSide<d()> c;
              const auto cap = c.cap();
              // Any rival, or a close one.
              const Vec<Rational, d()> step = *gen::nonzero_vector<d()>();
              const Rational share = *rc::gen::element(Rational(1), Rational(1, 100), Rational(1, 10000));
              const Vec<Rational, d()> rival = cap.center + step * share;
              RC_ASSERT((is_not_smaller_ball<Rational, d()>(c.units, cap, rival) == Verdict::holds));
              RC_ASSERT((is_not_smaller_ball<Rational, d()>(c.units, cap, cap.center) == Verdict::holds));
              if (squared_norm(rival) != 0)
                RC_ASSERT((is_not_smaller_cap<Rational, d()>(c.units, cap, rival) == Verdict::holds));
            });
          });
  t.holds("a larger claim is not believed: some rival is as small as the cap itself",
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

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const UnitsOnOneSide<4> c;
    const Vec<Rational, 4> rival = c.cap().center + *gen::rational_vector<4>();
    decide_by_all([]<class S>(const std::vector<Vec<S, 4>>& n,
                              const std::vector<S>& u) { return smallest_cap<S, 4>(n, u).verdict; },
                  c.units, c.coefficients);
    decide_by_all([]<class S>(const std::vector<Vec<S, 4>>& n, const std::vector<S>& u,
                              const Vec<S, 4>& g) { return is_not_smaller_ball<S, 4>(n, smallest_cap<S, 4>(n, u), g); },
                  c.units, c.coefficients, rival);
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
    // Another convex combination with the ball about it that encloses: its support is not on the boundary.
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

  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence,
                                  const t3_smallest::Case& c) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      return smallest_cap_hypotheses<Rational, 2>(c.units, c.coefficients) == Verdict::fails &&
             smallest_cap<Rational, 2>(c.units, c.coefficients).verdict == Verdict::fails;
    });
  };
  fails_without("the points are units", "for points of different lengths the nearest point is no center",
                t3_smallest::not_units);
  fails_without("c is the nearest point", "about another point of the hull the ball is not the smallest",
                t3_smallest::not_nearest);
  fails_without("0 is not in the hull", "if 0 is in the hull the nearest point is no direction",
                t3_smallest::zero_inside);
}

}  // namespace
}  // namespace proptests
