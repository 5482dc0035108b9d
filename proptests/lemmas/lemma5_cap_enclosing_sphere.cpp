#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

#include "proptests/counterexamples/lemma5_cap_enclosing_sphere.hpp"
#include "proptests/gen/cap.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;

template <int D>
bool is_degenerate(const Cap<Rational, D>& cap) {
  return sq(cap.cos_angle) == Rational(1) || cap.cos_angle == Rational(0) || cap.apex == cap.center;
}

const auto encloses_repaired = [](const auto& cap, const auto& x) { return encloses(cap_ball_repaired(cap), x); };
const auto encloses_printed = [](const auto& cap, const auto& x) { return encloses(cap_ball_printed(cap), x); };

// The paper's cap has the center 0.
template <int D>
gen::CapPoint<D> about_origin(const gen::CapPoint<D>& c) {
  return {{gen::RationalVec<D>::Zero(), c.cap.apex - c.cap.center, c.cap.cos_angle}, c.point - c.cap.center};
}

PROPTEST(lemma5_cap_enclosing_sphere) {
  t.example("the printed ball misses the apex of caps beyond a right angle, the repaired one does not",
            {.form = "printed"}, [] {
              bool all = true;
              for (const auto& cap : {lemma5::whole_circle, lemma5::wide, lemma5::hardly_wide})
                all = all && contains(cap, cap.apex) == Verdict::holds &&
                      cap_ball_encloses_printed(cap, cap.apex) == Verdict::fails &&
                      cap_ball_encloses_repaired(cap, cap.apex) == Verdict::holds;
              return Checked(all, 3);
            });

  t.refuted("the ball with center a cos(alpha) and radius r sin(alpha) encloses the cap",
            {.form = "printed", .number_type = "rational"}, [] {
              gen::for_some_dimension<1, 4>([](auto d) {
                const auto c = about_origin(*gen::cap_point<d>().as("case"));
                RC_ASSERT(cap_ball_encloses_printed(c.cap, c.point) == Verdict::holds);
              });
            });
  t.holds("up to a right angle the printed ball encloses the cap",
          {.form = "printed", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto c = about_origin(*gen::cap_point<d>().as("case"));
              RC_PRE(c.cap.cos_angle >= Rational(0));
              RC_CLASSIFY(is_degenerate<d>(c.cap), "degenerate");
              RC_ASSERT(cap_ball_encloses_printed(c.cap, c.point) == Verdict::holds);
            });
          });

  t.holds("the ball with center max(cos(alpha), 0) along the axis encloses the cap",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.3}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto c = *gen::cap_point<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(c.cap), "degenerate");
              RC_ASSERT(contains(c.cap, c.point) == Verdict::holds);
              RC_ASSERT(cap_ball_encloses_repaired(c.cap, c.point) == Verdict::holds);
            });
          });
  t.holds("no other ball of its size encloses the cap: two points of the cap are opposite on its surface",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.3}, [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const auto c = *gen::rimmed_cap<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(c.cap), "degenerate");
              RC_ASSERT(is_rim(c.cap, c.sine, c.rim_direction) == Verdict::holds);
              const auto smallest = smallest_cap_ball(c.cap, c.sine, c.rim_direction);
              RC_ASSERT(smallest.verdict == Verdict::holds);
              RC_ASSERT(is_smallest_cap_ball(c.cap, smallest) == Verdict::holds);
              RC_ASSERT(cap_ball_encloses_repaired(c.cap, smallest.first) == Verdict::holds);
              const SquaredBall<Rational, d> other{*gen::rational_vector<d>().as("center of another ball"),
                                                   *gen::rational().as("its squared radius")};
              RC_ASSERT(no_other_ball_that_small(smallest, other) == Verdict::holds);
              // The tightest ball about the other center, and the smallest about its own.
              const Rational needed = max_of(squared_distance(other.center, smallest.first),
                                             squared_distance(other.center, smallest.second));
              RC_ASSERT(no_other_ball_that_small(smallest, {other.center, needed}) == Verdict::holds);
              RC_ASSERT(needed >= smallest.ball.squared_radius);
            });
          });
  t.holds("the same from the cap alone, with roots", {.form = "repaired", .number_type = "exact root", .cases = 150},
          [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const Cap<Rational, d> cap{*gen::rational_vector<d>().as("center"), *gen::rational_vector<d>().as("apex"),
                                         *gen::unit_interval_rational() * Rational(2) - Rational(1)};
              RC_PRE(cap.apex != cap.center);
              const auto exact = lift<ExactRoot>(cap);
              RC_ASSERT(is_smallest_cap_ball(exact, smallest_cap_ball_by_roots(exact)) == Verdict::holds);
            });
          });

  t.holds("intervals never contradict the exact verdict on points in and out of the cap",
          {.number_type = "interval", .cases = 2000, .degenerate_at_least = 0.3}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = *gen::cap_point<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(c.cap), "degenerate");
              c.point[0] += *gen::nudge().as("nudge of the point");
              decide_by_all(encloses_repaired, c.cap, c.point);
              const gen::RationalVec<d> mirrored = c.cap.center * Rational(2) - c.point;
              decide_by_all(encloses_repaired, c.cap, mirrored);
              const auto centered = about_origin(c);
              decide_by_all(encloses_printed, centered.cap, centered.point);
            });
          });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .degenerate_at_least = 0.2}, [] {
    gen::for_some_dimension<2, 4>([](auto d) {
      const auto c = *gen::rimmed_cap<d>().as("case");
      RC_PRE(c.cap.apex != c.cap.center);
      RC_CLASSIFY(is_degenerate<d>(c.cap), "degenerate");
      const auto good = smallest_cap_ball(c.cap, c.sine, c.rim_direction);
      const Rational amount = *gen::positive_rational().as("amount");
      const auto shift = *gen::nonzero_vector<d>().as("shift");
      auto bad = good;
      switch (*rc::gen::inRange(0, 6).as("mutation")) {
        case 0: bad.ball.center += shift; break;
        case 1: bad.ball.squared_radius += amount; break;
        case 2: bad.ball.squared_radius -= amount; break;
        case 3: bad.first += shift; break;
        case 4: bad.second += shift; break;
        default: bad.height += amount;
      }
      RC_ASSERT(is_smallest_cap_ball(c.cap, bad) == Verdict::fails);
    });
  });
  t.holds("a ball with another height along the axis is rejected", {.number_type = "rational"}, [] {
    gen::for_some_dimension<2, 4>([](auto d) {
      const auto c = *gen::rimmed_cap<d>().as("case");
      RC_PRE(c.cap.apex != c.cap.center);
      auto bad = smallest_cap_ball(c.cap, c.sine, c.rim_direction);
      const Rational height = *gen::rational().as("height");
      RC_PRE(height != bad.height);
      // Consistent in itself: an enclosing ball about another point of the axis.
      const Rational r2 = squared_radius(c.cap);
      bad.height = height;
      bad.ball.center = c.cap.center + (c.cap.apex - c.cap.center) * height;
      bad.ball.squared_radius = r2 * (Rational(1) - Rational(2) * height * c.cap.cos_angle + height * height);
      RC_ASSERT(is_smallest_cap_ball(c.cap, bad) == Verdict::fails);
    });
  });
  t.holds("the ball of a narrower cap, smallest around two points of this one, is rejected", {.number_type = "rational"},
          [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const auto c = *gen::rimmed_cap<d>().as("case");
              const auto angle = *gen::cap_angle().as("angle of the narrower cap");
              RC_PRE(c.cap.apex != c.cap.center && angle.cosine > max_of(c.cap.cos_angle, Rational(0)));
              const Cap<Rational, d> narrower{c.cap.center, c.cap.apex, angle.cosine};
              const auto bad = smallest_cap_ball(narrower, angle.sine, c.rim_direction);
              RC_ASSERT(is_smallest_cap_ball(narrower, bad) == Verdict::holds);
              RC_ASSERT(is_smallest_cap_ball(c.cap, bad) == Verdict::fails);
            });
          });

  t.example("without cos(alpha) <= 1 there is no ball", {.form = "repaired", .hypothesis = "cos(alpha) <= 1"}, [] {
    return cap_has_points(lemma5::no_points) == Verdict::fails &&
           less(cap_ball_repaired(lemma5::no_points).squared_radius, Rational(0)) == Verdict::holds;
  });
  t.example("in R^1 a smaller ball encloses the cap", {.form = "repaired", .hypothesis = "d >= 2"}, [] {
    const auto& cap = lemma5::on_a_line;
    const auto& smaller = lemma5::point_on_a_line;
    const lemma5::Point<1> other_end = -cap.apex;
    return contains(cap, cap.apex) == Verdict::holds && contains(cap, other_end) == Verdict::fails &&
           encloses(smaller, cap.apex) == Verdict::holds &&
           smaller.squared_radius < cap_ball_repaired(cap).squared_radius &&
           smaller.squared_radius < cap_ball_printed(cap).squared_radius;
  });
  t.example("a direction that is not perpendicular gives no witness",
            {.form = "repaired", .hypothesis = "v is perpendicular to the axis"}, [] {
              const auto made = smallest_cap_ball(lemma5::narrow, lemma5::sine_of_narrow, lemma5::slanted);
              return is_rim(lemma5::narrow, lemma5::sine_of_narrow, lemma5::slanted) == Verdict::fails &&
                     is_smallest_cap_ball(lemma5::narrow, made) == Verdict::fails;
            });
  t.example("a sine that does not belong to the cosine gives no witness",
            {.form = "repaired", .hypothesis = "cos^2 + sin^2 = 1"}, [] {
              const auto made = smallest_cap_ball(lemma5::narrow, lemma5::not_its_sine, lemma5::perpendicular);
              return is_rim(lemma5::narrow, lemma5::not_its_sine, lemma5::perpendicular) == Verdict::fails &&
                     is_smallest_cap_ball(lemma5::narrow, made) == Verdict::fails;
            });
}

}  // namespace
}  // namespace proptests
