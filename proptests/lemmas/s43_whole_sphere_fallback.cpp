// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s43_whole_sphere_fallback.hpp"

#include "proptests/counterexamples/s43_whole_sphere_fallback.hpp"
#include "proptests/gen/cap_angle.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/vector.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_s43_whole_sphere_fallback {
namespace {

using namespace refitlab;
using s43_fallback::Case;

// Returns the mean ball of line 11, with its radius squared.
Case mean_ball_of(std::vector<Quaternion<Rational>> units, std::vector<Rational> coefficients) {
  Quaternion<Rational> sum = Quaternion<Rational>::Zero();
  for (const auto& n : units) sum += n;
  const Quaternion<Rational> center = sum / Rational(static_cast<int>(units.size()));
  Rational farthest(0);
  for (const auto& n : units) farthest = max_of(farthest, squared_distance(n, center));
  return {std::move(units), center, farthest, std::move(coefficients)};
}

Case any_mean_ball() {
  auto units = *gen::unit_quaternions(1, 5);
  auto coefficients = *gen::convex_weights(static_cast<int>(units.size()));
  return mean_ball_of(std::move(units), std::move(coefficients));
}

// Draws units that mostly lie on one side, so that the ball makes a cap.
Case any_cap() {
  const Quaternion<Rational> axis = *gen::unit_quaternion();
  auto units = *gen::unit_quaternions(1, 4);
  for (auto& n : units)
    if (dot(n, axis) < 0) n = -n;
  auto coefficients = *gen::convex_weights(static_cast<int>(units.size()));
  return mean_ball_of(std::move(units), std::move(coefficients));
}

BlendInCap<Rational> blend_of(const Case& c) {
  return blend_in_cap<Rational>(c.units, c.center, c.squared_radius, c.coefficients);
}

bool is_degenerate(const Case& c) {
  bool equal_units = false;
  for (std::size_t k = 1; k < c.units.size(); ++k)
    equal_units = equal_units || c.units[k] == c.units[0] || c.units[k] == -c.units[0];
  return equal_units || c.squared_radius == 0 || c.squared_radius == 1 || squared_norm(c.center) == 0;
}

// Draws three or four units in a ball that makes a cap, so that there is one between the first and the last.
Case several_in_cap() {
  auto units = *gen::unit_quaternions(3, 4);
  for (auto& n : units)
    if (dot(n, units[0]) < 0) n = -n;
  auto coefficients = *gen::convex_weights(static_cast<int>(units.size()));
  Case c = mean_ball_of(std::move(units), std::move(coefficients));
  RC_PRE(ball_makes_cap(c.center, c.squared_radius) == Verdict::holds);
  return c;
}

// Puts all of the weight on one unit, or keeps the case's own weights.
void lean_on(Case& c, std::size_t k) {
  if (*rc::gen::arbitrary<bool>().as("the case's own weights")) return;
  c.coefficients.assign(c.units.size(), Rational(0));
  c.coefficients[k] = 1;
}

Verdict units_of(const Case& c) { return units_in_ball<Rational>(c.units, c.center, c.squared_radius); }
std::size_t some_unit(const Case& c) { return *rc::gen::inRange<std::size_t>(0, c.units.size()).as("which unit"); }

void hypotheses_need_each_part(Suite& t) {
  needs_part(t, "one of the vectors is longer or shorter than 1, the others are units", [] {
    Case c = several_in_cap();
    const auto k = some_unit(c);
    const Rational factor = Rational(1) + *gen::positive_rational().as("factor");
    const bool longer = *rc::gen::arbitrary<bool>().as("longer");
    c.units[k] = longer ? Quaternion<Rational>(c.units[k] * factor) : Quaternion<Rational>(c.units[k] / factor);
    c.squared_radius = max_of(c.squared_radius, squared_distance(c.units[k], c.center));
    RC_PRE(ball_makes_cap(c.center, c.squared_radius) == Verdict::holds);
    lean_on(c, k);
    return Weakening{units_of(c), is_blend_in_cap<Rational>(c.units, c.center, c.squared_radius, c.coefficients, blend_of(c))};
  });
  needs_part(t, "one of the units is not in the ball, the others are", [] {
    Case c = several_in_cap();
    const auto k = some_unit(c);
    c.units[k] = *gen::unit_quaternion();
    RC_PRE(squared_distance(c.units[k], c.center) > c.squared_radius);
    lean_on(c, k);
    return Weakening{units_of(c), blend_of(c).verdict};
  });
  needs_part(t, "the coefficients are convex", [] {
    Case c = several_in_cap();
    const auto k = some_unit(c);
    const Rational amount = *gen::positive_rational().as("amount");
    c.coefficients[(k + 1) % c.units.size()] += c.coefficients[k] + amount;
    c.coefficients[k] = -amount;
    return Weakening{is_convex<Rational>(c.coefficients), blend_of(c).verdict};
  });
  needs_part(t, "r^2 < 1 + ||c||^2, and not equal to it either", [] {
    // Two units are on the rim of a cap of a half or more: their middle is 0 or behind.
    const auto frame = *gen::perpendicular_pair<4>();
    const auto angle = *gen::cap_angle().as("angle");
    RC_PRE(angle.cosine <= 0 && angle.sine > 0);
    Case c;
    c.center = frame.first * *gen::positive_rational().as("distance");
    c.units = {frame.first * angle.cosine + frame.second * angle.sine, frame.first * angle.cosine - frame.second * angle.sine};
    c.squared_radius = squared_distance(c.units[0], c.center);
    c.coefficients = *gen::convex_weights(2);
    if (*rc::gen::arbitrary<bool>().as("their middle")) c.coefficients = {Rational(1, 2), Rational(1, 2)};
    RC_ASSERT(units_of(c) == Verdict::holds);
    const auto blend = blend_of(c);
    RC_ASSERT(is_blend_in_cap<Rational>(c.units, c.center, c.squared_radius, c.coefficients, blend) == Verdict::fails);
    RC_ASSERT(rotated_vectors_cap_repaired(c.center, c.squared_radius).cos_angle == -1);
    return Weakening{ball_makes_cap(c.center, c.squared_radius), blend.verdict};
  });
  t.holds("units on the surface of their ball are in it", {.number_type = "rational"}, [] {
    const auto u = *gen::unit_quaternion(), center = *gen::rational_vector<4>();
    const Rational square = squared_distance(u, center);
    RC_ASSERT(units_in_ball<Rational>(std::vector{u}, center, square) == Verdict::holds);
  });
  t.holds("the printed border is r_E = 1 and the repaired one N = 0, both with the border", {.number_type = "rational"}, [] {
    const auto center = *gen::rational_vector<4>();
    const Rational half = Rational(1) + squared_norm(center), amount = *gen::positive_rational();
    RC_ASSERT(fallback_is_needed_printed(Rational(1)) == Verdict::holds);
    RC_ASSERT(fallback_is_needed_printed(Rational(1 / (1 + amount))) == Verdict::fails);
    RC_ASSERT(fallback_is_needed_repaired(center, half) == Verdict::holds);
    RC_ASSERT(fallback_is_needed_repaired(center, Rational(half / (1 + amount))) ==
              verdict_of(center == Quaternion<Rational>::Zero()));
  });
}

void verdicts_and_checks_need_each_part(Suite& t) {
  t.holds("the verdict on a blend of known length is that of its words, for any ball", {.number_type = "rational", .cases = 2000},
          [] {
            const auto u = *gen::unit_quaternion(), center = *gen::rational_vector<4>();
            const Rational length = *gen::rational().as("signed length"), along = length * dot(u, center);
            Rational n = *gen::rational().as("N");
            if (length != 0 && *rc::gen::arbitrary<bool>().as("on the rim")) n = Rational(2) * along / abs(length);
            const Rational square = Rational(1) + squared_norm(center) - n;
            const auto made = blend_in_cap<Rational>(std::vector{u}, center, square, std::vector{length});
            const bool in_cap = Rational(2) * along >= n * abs(length);
            RC_CLASSIFY(in_cap && n < 0, "more than half, and in the cap");
            RC_CLASSIFY(!in_cap && n < 0, "more than half, and not in the cap");
            RC_ASSERT(made.along == along);
            RC_ASSERT(made.verdict == verdict_of(length != 0 && in_cap));
          });
  t.holds("a blend that is wrong in one part is rejected", {.number_type = "rational"}, [] {
    using Q4 = Quaternion<Rational>;
    const int j = *rc::gen::inRange(0, 4).as("axis"), i = *rc::gen::inRange(0, 4).as("coordinate");
    Q4 axis = Q4::Zero(), other = Q4::Zero();
    axis[j] = 1, other[i] = 1;
    // For a ball about the axis with r^2 = 1, N / 2 is 1/2.
    const auto verdict = [&](const Q4& unit, const Rational& coefficient, const Q4& blend, const Rational& square) {
      return is_blend_in_cap<Rational>(std::vector{unit}, axis, square, std::vector{coefficient},
                                       {Verdict::holds, blend, dot(blend, axis)});
    };
    const Rational half(1, 2), amount = *gen::positive_rational().as("amount");
    const Q4 middle = axis * half;
    RC_ASSERT(verdict(axis, half, middle, Rational(1)) == Verdict::holds);                 // This is equality in (b, c) >= N / 2.
    RC_ASSERT(verdict(axis, Rational(1), axis, Rational(1)) == Verdict::holds);            // This is equality in ||b|| <= 1.
    RC_ASSERT(verdict(axis, half, middle + other * half, Rational(1)) == Verdict::fails);  // one coordinate
    RC_ASSERT(verdict(axis, half + amount, axis * (half + amount), Rational(1)) == verdict_of(amount <= half));  // the length
    RC_ASSERT(verdict(axis, half / (1 + amount), middle / (1 + amount), Rational(1)) == Verdict::fails);         // the height
    RC_ASSERT(verdict(axis, half, middle, Rational(2)) == Verdict::fails);                                       // N = 0
    RC_ASSERT(verdict(axis, half, middle, Rational(2 + amount)) == Verdict::fails);                              // N < 0
    const BlendInCap<Rational> higher{Verdict::holds, middle, half + amount};
    RC_ASSERT(is_blend_in_cap<Rational>(std::vector{axis}, axis, Rational(1), std::vector{half}, higher) == Verdict::fails);
  });
  t.holds("a bound on rotated vectors has the cosine of an angle, and the angle between them within it",
          {.number_type = "rational"}, [] {
            const auto apex = *gen::nonzero_quaternion(), q = *gen::nonzero_quaternion();
            const Vec<Rational, 3> v = *gen::nonzero_vector<3>(), zero = Vec<Rational, 3>::Zero();
            const Rational amount = *gen::positive_rational();
            const auto bounded = [&](const Rational& cosine, const Quaternion<Rational>& blend, const Vec<Rational, 3>& x) {
              return rotated_blend_is_bounded<Rational>({apex, cosine}, blend, x);
            };
            RC_ASSERT(bounded(Rational(-1), q, v) == Verdict::holds);
            RC_ASSERT(bounded(-1 - amount, q, v) == Verdict::fails);
            RC_ASSERT(bounded(Rational(1), apex, v) == Verdict::holds);
            RC_ASSERT(bounded(1 + amount, q, zero) == Verdict::fails);
            const Rational cosine = dot(rotate_by(apex, v), rotate_by(q, v)) / squared_norm(v);
            RC_ASSERT(bounded(cosine, q, v) == Verdict::holds);
            if (cosine < 1) RC_ASSERT(bounded(cosine + (1 - cosine) / (1 + amount), q, v) == Verdict::fails);
          });
}

void printed_statements_are_refuted(Suite& t) {
  t.refuted("a ball with r_E >= 1 needs the whole sphere", {.form = "implied", .number_type = "rational"}, [] {
    const Case c = any_cap();
    RC_ASSERT(implies(fallback_is_needed_printed(c.squared_radius), fallback_is_needed_repaired(c.center, c.squared_radius)) ==
              Verdict::holds);
  });
  t.example("a mean ball of radius 6/5 that makes a valid cap refutes the printed border", {.form = "printed"}, [] {
    const Case& c = s43_fallback::thrown_away;
    const auto cap = rotated_vectors_cap_repaired(c.center, c.squared_radius);
    return units_in_ball<Rational>(c.units, c.center, c.squared_radius) == Verdict::holds &&
           fallback_is_needed_printed(c.squared_radius) == Verdict::holds &&
           fallback_is_needed_repaired(c.center, c.squared_radius) == Verdict::fails && blend_of(c).verdict == Verdict::holds &&
           (cap.cos_angle + 1) / 2 == Rational(1, 325);
  });
  t.refuted("line 15 makes a ball of every mean ball", {.form = "printed", .number_type = "rational"}, [] {
    const Case c = any_mean_ball();
    RC_ASSERT(line_15_makes_ball_printed(c.center, c.squared_radius) == Verdict::holds);
  });
  t.example("a mean ball past half of the sphere and one about 0 refute line 15", {.form = "printed"}, [] {
    const Case &negative = s43_fallback::negative_radius, &zero = s43_fallback::zero_center;
    bool all = scaled_distance(negative.center, negative.squared_radius) == Rational(-7, 10);
    for (const Case* c : {&negative, &zero}) {
      const Case again = mean_ball_of(c->units, c->coefficients);
      all = all && again.center == c->center && again.squared_radius == c->squared_radius &&
            line_15_makes_ball_printed(c->center, c->squared_radius) == Verdict::fails &&
            rotated_vectors_cap_repaired(c->center, c->squared_radius).cos_angle == Rational(-1);
    }
    return Checked(all, 2);
  });
}

void repaired_statements_hold(Suite& t) {
  t.holds("if r^2 < 1 + ||c||^2, every blend is in the cap and none is 0",
          {.form = "repaired", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const Case c = any_cap();
            RC_PRE(ball_makes_cap(c.center, c.squared_radius) == Verdict::holds);
            RC_CLASSIFY(is_degenerate(c), "degenerate");
            RC_CLASSIFY(c.squared_radius >= 1, "thrown away as printed");
            RC_ASSERT(units_in_ball<Rational>(c.units, c.center, c.squared_radius) == Verdict::holds);
            const auto blend = blend_of(c);
            RC_ASSERT(blend.verdict == Verdict::holds);
            RC_ASSERT(is_blend_in_cap<Rational>(c.units, c.center, c.squared_radius, c.coefficients, blend) == Verdict::holds);
          });
  t.holds("with the fallback every blend that is not 0 takes v into the cap of line 13",
          {.form = "repaired", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const Case c = *rc::gen::arbitrary<bool>() ? any_cap() : any_mean_ball();
            const auto blend = blend_of(c).blend;
            RC_PRE(squared_norm(blend) != 0);
            RC_CLASSIFY(is_degenerate(c), "degenerate");
            const auto cap = rotated_vectors_cap_repaired(c.center, c.squared_radius);
            RC_CLASSIFY(cap.cos_angle == -1, "falls back");
            RC_ASSERT(rotated_blend_is_bounded(cap, blend, *gen::rational_vector<3>()) == Verdict::holds);
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const Case c = *rc::gen::arbitrary<bool>() ? any_cap() : any_mean_ball();
    decide_by_all([]<class S>(const std::vector<Quaternion<S>>& n, const Quaternion<S>& center, const S& r2,
                              const std::vector<S>& u) { return blend_in_cap<S>(n, center, r2, u).verdict; },
                  c.units, c.center, c.squared_radius, c.coefficients);
    decide_by_all([]<class S>(const Quaternion<S>& center, const S& r2) { return fallback_is_needed_repaired<S>(center, r2); },
                  c.center, c.squared_radius);
    decide_by_all([]<class S>(const Quaternion<S>& center, const S& r2) { return line_15_makes_ball_printed<S>(center, r2); },
                  c.center, c.squared_radius);
  });

  t.holds("a mutated blend is rejected", {.number_type = "rational", .cases = 300}, [] {
    const Case c = any_cap();
    RC_PRE(ball_makes_cap(c.center, c.squared_radius) == Verdict::holds);
    const auto rejected = [&](const BlendInCap<Rational>& w, const std::vector<Rational>& u) {
      return is_blend_in_cap<Rational>(c.units, c.center, c.squared_radius, u, w) == Verdict::fails;
    };
    auto along = blend_of(c), blend = along;
    const Rational bump = *gen::positive_rational();
    along.along += bump;
    blend.blend[*rc::gen::inRange(0, 4)] -= bump;
    RC_ASSERT(rejected(along, c.coefficients));
    RC_ASSERT(rejected(blend, c.coefficients));
    auto u = c.coefficients;
    u[0] += bump;
    RC_ASSERT(rejected(blend_of(c), u));
  });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const Case& c) {
    t.example(sentence, {.form = "repaired", .hypothesis = hypothesis}, [&] {
      const Verdict all = units_in_ball<Rational>(c.units, c.center, c.squared_radius) &
                          ball_makes_cap(c.center, c.squared_radius) & is_convex<Rational>(c.coefficients);
      return all == Verdict::fails && blend_of(c).verdict == Verdict::fails &&
             is_blend_in_cap<Rational>(c.units, c.center, c.squared_radius, c.coefficients, blend_of(c)) == Verdict::fails;
    });
  };
  fails_without("r^2 < 1 + ||c||^2", "past half of the sphere a blend leaves the cap", s43_fallback::past_half);
  fails_without("the vectors are units", "a short vector in the ball is far from the axis", s43_fallback::short_one);
  fails_without("the ball encloses the units", "a unit outside the ball is outside the cap", s43_fallback::not_enclosed);
  fails_without("the coefficients are convex", "a negative multiple of a unit is outside the cap", s43_fallback::not_convex);
  t.holds("a ball of units with r^2 < 1 + ||c||^2 is not about 0", {.form = "repaired", .number_type = "rational"}, [] {
    const Case c = any_mean_ball();
    RC_ASSERT(implies(less(Rational(0), scaled_distance(c.center, c.squared_radius)),
                      less(Rational(0), squared_norm(c.center))) == Verdict::holds);
  });
  t.example("past half of the sphere a unit is still on the rim, and of two opposite units the mean is nowhere", {}, [] {
    const Case &rim = s43_fallback::past_half, &zero = s43_fallback::zero_center;
    const std::vector<Rational> first{1, 0}, mean{Rational(1, 2), Rational(1, 2)};
    return blend_in_cap<Rational>(rim.units, rim.center, rim.squared_radius, first).verdict == Verdict::holds &&
           blend_in_cap<Rational>(zero.units, zero.center, zero.squared_radius, first).verdict == Verdict::holds &&
           blend_in_cap<Rational>(zero.units, zero.center, zero.squared_radius, mean).verdict == Verdict::fails;
  });
  t.example("a ball of nothing about 0 makes no cap, though its distance is positive", {}, [] {
    const Quaternion<Rational> zero = Quaternion<Rational>::Zero();
    return scaled_distance(zero, Rational(1, 4)) > 0 && ball_makes_cap(zero, Rational(1, 4)) == Verdict::fails;
  });
}

PROPTEST(s43_whole_sphere_fallback) {
  hypotheses_need_each_part(t);
  verdicts_and_checks_need_each_part(t);
  printed_statements_are_refuted(t);
  repaired_statements_hold(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s43_whole_sphere_fallback
