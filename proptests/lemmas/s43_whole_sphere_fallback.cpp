#include "lemmas/s43_whole_sphere_fallback.hpp"

#include "proptests/counterexamples/s43_whole_sphere_fallback.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using s43_fallback::Case;

// The mean ball of line 11, with its radius squared.
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

// Units that mostly lie on one side, so that the ball makes a cap.
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

PROPTEST(s43_whole_sphere_fallback) {
  t.refuted("a ball with r_E >= 1 needs the whole sphere", {.form = "printed", .number_type = "rational"}, [] {
    const Case c = any_cap();
    RC_ASSERT(implies(fallback_is_needed_printed(c.squared_radius),
                      fallback_is_needed_repaired(c.center, c.squared_radius)) == Verdict::holds);
  });
  t.example("a mean ball of radius 6/5 that makes a valid cap refutes the printed border", {.form = "printed"}, [] {
    const Case& c = s43_fallback::thrown_away;
    const auto cap = rotated_vectors_cap_repaired(c.center, c.squared_radius);
    return units_in_ball<Rational>(c.units, c.center, c.squared_radius) == Verdict::holds &&
           fallback_is_needed_printed(c.squared_radius) == Verdict::holds &&
           fallback_is_needed_repaired(c.center, c.squared_radius) == Verdict::fails &&
           blend_of(c).verdict == Verdict::holds && (cap.cos_angle + 1) / 2 == Rational(1, 325);
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

  t.holds("if r^2 < 1 + ||c||^2, every blend is in the cap and none is 0",
          {.form = "repaired", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const Case c = any_cap();
            RC_PRE(ball_makes_cap(c.center, c.squared_radius) == Verdict::holds);
            RC_CLASSIFY(is_degenerate(c), "degenerate");
            RC_CLASSIFY(c.squared_radius >= 1, "thrown away as printed");
            RC_ASSERT(units_in_ball<Rational>(c.units, c.center, c.squared_radius) == Verdict::holds);
            const auto blend = blend_of(c);
            RC_ASSERT(blend.verdict == Verdict::holds);
            RC_ASSERT(is_blend_in_cap<Rational>(c.units, c.center, c.squared_radius, c.coefficients, blend) ==
                      Verdict::holds);
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

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const Case c = *rc::gen::arbitrary<bool>() ? any_cap() : any_mean_ball();
    decide_by_all([]<class S>(const std::vector<Quaternion<S>>& n, const Quaternion<S>& center, const S& r2,
                              const std::vector<S>& u) { return blend_in_cap<S>(n, center, r2, u).verdict; },
                  c.units, c.center, c.squared_radius, c.coefficients);
    decide_by_all(
        []<class S>(const Quaternion<S>& center, const S& r2) { return fallback_is_needed_repaired<S>(center, r2); },
        c.center, c.squared_radius);
    decide_by_all(
        []<class S>(const Quaternion<S>& center, const S& r2) { return line_15_makes_ball_printed<S>(center, r2); },
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

  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const Case& c) {
    t.example(sentence, {.form = "repaired", .hypothesis = hypothesis}, [&] {
      const Verdict all = units_in_ball<Rational>(c.units, c.center, c.squared_radius) &
                          ball_makes_cap(c.center, c.squared_radius) & is_convex<Rational>(c.coefficients);
      return all == Verdict::fails && blend_of(c).verdict == Verdict::fails &&
             is_blend_in_cap<Rational>(c.units, c.center, c.squared_radius, c.coefficients, blend_of(c)) ==
                 Verdict::fails;
    });
  };
  fails_without("r^2 < 1 + ||c||^2", "past half of the sphere a blend leaves the cap", s43_fallback::past_half);
  fails_without("the vectors are units", "a short vector in the ball is far from the axis", s43_fallback::short_one);
  fails_without("the ball encloses the units", "a unit outside the ball is outside the cap",
                s43_fallback::not_enclosed);
  fails_without("the coefficients are convex", "a negative multiple of a unit is outside the cap",
                s43_fallback::not_convex);
  t.holds("a ball of units with r^2 < 1 + ||c||^2 is not about 0", {.form = "repaired", .number_type = "rational"}, [] {
    const Case c = any_mean_ball();
    RC_ASSERT(implies(less(Rational(0), scaled_distance(c.center, c.squared_radius)),
                      less(Rational(0), squared_norm(c.center))) == Verdict::holds);
  });
  t.example(
      "past half of the sphere a unit is still on the rim, and of two opposite units the mean is nowhere", {}, [] {
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

}  // namespace
}  // namespace proptests
