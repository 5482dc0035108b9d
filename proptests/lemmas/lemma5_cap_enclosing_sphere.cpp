// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

#include "proptests/counterexamples/lemma5_cap_enclosing_sphere.hpp"
#include "proptests/gen/cap.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_lemma5_cap_enclosing_sphere {
namespace {

using namespace refitlab;

template <int D>
bool is_degenerate(const Cap<Rational, D>& cap) {
  return sq(cap.cos_angle) == Rational(1) || cap.cos_angle == Rational(0) || cap.apex == cap.center;
}

const auto encloses_repaired = [](const auto& cap, const auto& x) { return encloses(cap_ball_repaired(cap), x); };
const auto encloses_printed = [](const auto& cap, const auto& x) { return encloses(cap_ball_printed(cap), x); };

// Returns the cap moved to the center 0, where the paper has it.
template <int D>
gen::CapPoint<D> about_origin(const gen::CapPoint<D>& c) {
  return {{gen::RationalVec<D>::Zero(), c.cap.apex - c.cap.center, c.cap.cos_angle}, c.point - c.cap.center};
}

// Draws a cap with r > 0 and an angle strictly between 0 and pi/2.
template <int D>
gen::RimmedCap<D> narrow_cap() {
  const auto c = *gen::rimmed_cap<D>().as("cap");
  RC_PRE(c.cap.apex != c.cap.center && c.cap.cos_angle > Rational(0) && c.cap.cos_angle < Rational(1));
  return c;
}

void rim_hypotheses_need_each_part(Suite& t) {
  const auto made_by = [](const auto& c) {
    return is_smallest_cap_ball(c.cap, smallest_cap_ball(c.cap, c.sine, c.rim_direction));
  };
  needs_part_in<2, 4>(t, "v is perpendicular to the axis, to either side", [=](auto d) {
    auto c = narrow_cap<d>();
    const auto tilt = *gen::cap_angle().as("tilt");
    RC_PRE(tilt.cosine != Rational(0));
    // The direction is as long.
    c.rim_direction = (c.cap.apex - c.cap.center) * tilt.cosine + c.rim_direction * tilt.sine;
    return Weakening{is_rim(c.cap, c.sine, c.rim_direction), made_by(c)};
  });
  needs_part_in<2, 4>(t, "v is as long as the axis, not longer and not shorter", [=](auto d) {
    auto c = narrow_cap<d>();
    const Rational factor = Rational(1) + *gen::positive_rational().as("factor");
    c.rim_direction = *rc::gen::arbitrary<bool>().as("longer") ? gen::RationalVec<d>(c.rim_direction * factor)
                                                               : gen::RationalVec<d>(c.rim_direction / factor);
    return Weakening{is_rim(c.cap, c.sine, c.rim_direction), made_by(c)};
  });
  needs_part_in<2, 4>(t, "cos^2 + sin^2 = 1, not more and not less", [=](auto d) {
    auto c = narrow_cap<d>();
    const Rational factor = Rational(1) + *gen::positive_rational().as("factor");
    c.sine = *rc::gen::arbitrary<bool>().as("more") ? Rational(c.sine * factor) : Rational(c.sine / factor);
    return Weakening{is_rim(c.cap, c.sine, c.rim_direction), made_by(c)};
  });
  needs_part_in<2, 4>(t, "cos(alpha) <= 1", [](auto d) {
    auto c = narrow_cap<d>();
    c.cap.cos_angle = 1;
    RC_ASSERT(cap_has_points(c.cap) == Verdict::holds);
    c.cap.cos_angle += *gen::positive_rational().as("amount");
    const auto made = smallest_cap_ball(c.cap, c.sine, c.rim_direction);
    // A cap of no radius is rejected, too.
    const Cap<Rational, d> no_radius{c.cap.center, c.cap.center, c.cap.cos_angle};
    const gen::RationalVec<d> none = gen::RationalVec<d>::Zero();
    RC_ASSERT(smallest_cap_ball(no_radius, Rational(0), none).verdict == Verdict::fails);
    return Weakening{cap_has_points(c.cap), made.verdict};
  });
  t.holds("a sine is not negative; that of the angles 0 and pi is 0", {.number_type = "rational"}, [] {
    gen::for_some_dimension<2, 4>([](auto d) {
      const auto c = *gen::rimmed_cap<d>().as("cap");
      RC_ASSERT(is_rim(c.cap, c.sine, c.rim_direction) == Verdict::holds);
      RC_ASSERT(is_rim(c.cap, Rational(-c.sine), c.rim_direction) == verdict_of(c.sine == Rational(0)));
      auto whole = c.cap, point = c.cap;
      whole.cos_angle = -1, point.cos_angle = 1;
      RC_ASSERT(is_rim(whole, Rational(0), c.rim_direction) == Verdict::holds);
      RC_ASSERT(is_rim(point, Rational(0), c.rim_direction) == Verdict::holds);
    });
  });
}

void cap_hypotheses_need_each_part(Suite& t) {
  needs_part_in<1, 4>(t, "the point is in the cap", [](auto d) {
    auto c = about_origin(*gen::cap_point<d>().as("case"));
    c.point = *gen::sphere_point<d>().as("direction") * *gen::positive_rational().as("distance");
    RC_PRE(contains(c.cap, c.point) == Verdict::fails);
    RC_ASSERT(cap_ball_encloses_repaired(c.cap, c.point) == Verdict::holds);
    RC_ASSERT(cap_ball_encloses_printed(c.cap, c.point) == Verdict::holds);
    return Weakening{contains(c.cap, c.point), encloses(cap_ball_repaired(c.cap), c.point)};
  });
  needs_part_in<1, 4>(t, "as printed, the cap's center is 0", [](auto d) {
    const auto c = *gen::cap_point<d>().as("case");
    RC_PRE(c.cap.center != gen::RationalVec<d>::Zero());
    RC_ASSERT(cap_ball_encloses_printed(c.cap, c.point) == Verdict::holds);
    return Weakening{cap_ball_hypotheses_printed(c.cap), encloses(cap_ball_printed(c.cap), c.point)};
  });
  t.holds("as printed, the cosine is that of an angle", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      auto c = about_origin(*gen::cap_point<d>().as("case"));
      const Rational cosine = *rc::gen::oneOf(rc::gen::element(Rational(1), Rational(-1)), gen::rational()).as("cosine");
      c.cap.cos_angle = cosine;
      RC_ASSERT(cap_ball_hypotheses_printed(c.cap) == verdict_of(abs(cosine) <= Rational(1)));
      c.cap.cos_angle = Rational(-1) - *gen::positive_rational().as("amount");  // Its ball has no real radius.
      RC_ASSERT(cap_ball_encloses_printed(c.cap, c.point) == Verdict::holds);
    });
  });
  t.example("an interval of angles about pi/2 decides neither of the two shapes of the ball", {}, [] {
    const Interval around_zero(-1e-3, 1e-3);
    const Cap<Interval, 2> cap{{Interval(0), Interval(0)}, {Interval(1), Interval(0)}, around_zero};
    return smallest_cap_ball<Interval, 2>(cap, Interval(1), {Interval(0), Interval(1)}).verdict == Verdict::undecided;
  });
  t.example("the axis may point along any coordinate, forwards or backwards", {.number_type = "exact root"}, [] {
    long tried = 0;
    bool all = true;
    const auto along_axes = [&](auto d) {
      for (int i = 0; i < int(d); ++i)
        for (const int sign : {1, -1}) {
          Vec<ExactRoot, d> apex = Vec<ExactRoot, d>::Constant(ExactRoot(0));
          const Vec<ExactRoot, d> center = apex;
          apex[i] = sign;
          const Cap<ExactRoot, d> cap{center, apex, ExactRoot(0.5)};
          all = all && is_smallest_cap_ball(cap, smallest_cap_ball_by_roots(cap)) == Verdict::holds;
          ++tried;
        }
    };
    along_axes(gen::Dimension<2>{}), along_axes(gen::Dimension<3>{}), along_axes(gen::Dimension<4>{});
    return Checked(all, tried);
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("a ball about another cross-section of the sphere misses a part of the cap", {.number_type = "rational"}, [] {
    gen::for_some_dimension<2, 4>([](auto d) {
      auto c = *gen::rimmed_cap<d>().as("cap");
      RC_PRE(c.cap.apex != c.cap.center);
      const auto section = *gen::cap_angle().as("section");
      const Rational h = section.cosine;
      // Its ends are in the cap. The farthest point of the cap is missed if 0 < h, the apex if h < 0.
      RC_PRE(c.cap.cos_angle < h && h < Rational(1) && h != Rational(0));
      RC_CLASSIFY(h < Rational(0), "a negative height");
      CapBall<Rational, d> bad;
      bad.verdict = Verdict::holds;
      bad.height = h;
      bad.ball = {c.cap.center + (c.cap.apex - c.cap.center) * h, (Rational(1) - h * h) * squared_radius(c.cap)};
      bad.first = bad.ball.center + c.rim_direction * section.sine;
      bad.second = bad.ball.center - c.rim_direction * section.sine;
      RC_ASSERT(contains(c.cap, bad.first) == Verdict::holds && contains(c.cap, bad.second) == Verdict::holds);
      RC_ASSERT(is_smallest_cap_ball(c.cap, bad) == Verdict::fails);
    });
  });
  t.holds("an end that is not in the cap, or not opposite in one coordinate, is rejected", {.number_type = "rational"}, [] {
    gen::for_some_dimension<2, 4>([](auto d) {
      const auto center = *gen::rational_vector<d>().as("center");
      const auto u = *gen::sphere_point<d>().as("axis");
      // From pi/2 on the ball is the whole sphere's.
      const Rational cosine = -*gen::unit_interval_rational().as("- cosine");
      const Cap<Rational, d> cap{center, center + u, cosine}, whole{center, center + u, Rational(-1)};
      CapBall<Rational, d> w{Verdict::holds, {center, Rational(1)}, Rational(0), center + u, center - u};
      RC_ASSERT(is_smallest_cap_ball(whole, w) == Verdict::holds);
      RC_ASSERT(is_smallest_cap_ball(cap, w) == verdict_of(cosine == Rational(-1)));  // the second is behind
      std::swap(w.first, w.second);
      RC_ASSERT(is_smallest_cap_ball(cap, w) == verdict_of(cosine == Rational(-1)));  // the first is
      const int i = *rc::gen::inRange(0, int(d)).as("coordinate");
      w.second[i] = w.first[i];
      RC_ASSERT(is_smallest_cap_ball(whole, w) == verdict_of(u[i] == Rational(0)));
    });
  });
  t.holds("a ball of the whole sphere, with one point of the cap for both ends, is not the smallest", {.number_type = "rational"},
          [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const auto c = narrow_cap<d>();
              const CapBall<Rational, d> w{
                  Verdict::holds, {c.cap.center, squared_radius(c.cap)}, Rational(0), c.cap.apex, c.cap.apex};
              RC_ASSERT(is_smallest_cap_ball(c.cap, w) == Verdict::fails);
            });
          });
  t.holds("what is said of another ball is what its words say, whatever the witness", {.number_type = "rational", .cases = 2000},
          [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const auto c = *gen::rimmed_cap<d>().as("cap");
              auto w = smallest_cap_ball(c.cap, c.sine, c.rim_direction);
              if (*rc::gen::arbitrary<bool>().as("one end only")) w.second = w.first;
              if (*rc::gen::arbitrary<bool>().as("a larger ball")) w.ball.squared_radius += *gen::positive_rational().as("more");
              const auto center = *rc::gen::oneOf(rc::gen::just(w.ball.center), rc::gen::just(w.first), rc::gen::just(w.second),
                                                  gen::rational_vector<d>())
                                       .as("center of the other");
              const Rational first = squared_distance(center, w.first), second = squared_distance(center, w.second);
              const Rational square =
                  *rc::gen::element(first, second, w.ball.squared_radius, Rational(0)).as("squared radius of the other");
              const bool holds_both = first <= square && second <= square;
              const bool same = center == w.ball.center && square == w.ball.squared_radius;
              RC_CLASSIFY(holds_both && !same && square <= w.ball.squared_radius, "refutes the witness");
              RC_CLASSIFY(holds_both && !same && square == w.ball.squared_radius, "as large, about another center");
              RC_ASSERT(no_other_ball_that_small(w, {center, square}) ==
                        verdict_of(!holds_both || same || w.ball.squared_radius < square));
            });
          });
}

void printed_ball_misses_wide_caps(Suite& t) {
  t.example("the printed ball misses the apex of caps beyond a right angle, the repaired one does not", {.form = "printed"}, [] {
    bool all = true;
    for (const auto& cap : {lemma5::whole_circle, lemma5::wide, lemma5::hardly_wide})
      all = all && contains(cap, cap.apex) == Verdict::holds && cap_ball_encloses_printed(cap, cap.apex) == Verdict::fails &&
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
}

void repaired_ball_is_the_smallest(Suite& t) {
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
              // This is the tightest ball about the other center, beside the smallest one about its own.
              const Rational needed =
                  max_of(squared_distance(other.center, smallest.first), squared_distance(other.center, smallest.second));
              RC_ASSERT(no_other_ball_that_small(smallest, {other.center, needed}) == Verdict::holds);
              RC_ASSERT(needed >= smallest.ball.squared_radius);
            });
          });
  t.holds("the same from the cap alone, with roots", {.form = "repaired", .number_type = "exact root", .cases = 150}, [] {
    gen::for_some_dimension<2, 4>([](auto d) {
      const Cap<Rational, d> cap{*gen::rational_vector<d>().as("center"), *gen::rational_vector<d>().as("apex"),
                                 *gen::unit_interval_rational() * Rational(2) - Rational(1)};
      RC_PRE(cap.apex != cap.center);
      const auto exact = lift<ExactRoot>(cap);
      RC_ASSERT(is_smallest_cap_ball(exact, smallest_cap_ball_by_roots(exact)) == Verdict::holds);
    });
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
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
      // The ball is consistent in itself: it encloses, about another point of the axis.
      const Rational r2 = squared_radius(c.cap);
      bad.height = height;
      bad.ball.center = c.cap.center + (c.cap.apex - c.cap.center) * height;
      bad.ball.squared_radius = r2 * (Rational(1) - Rational(2) * height * c.cap.cos_angle + height * height);
      RC_ASSERT(is_smallest_cap_ball(c.cap, bad) == Verdict::fails);
    });
  });
  t.holds("the ball of a narrower cap, smallest around two points of this one, is rejected", {.number_type = "rational"}, [] {
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
}

void pinned_cases(Suite& t) {
  t.example("without cos(alpha) <= 1 there is no ball", {.form = "repaired", .hypothesis = "cos(alpha) <= 1"}, [] {
    return cap_has_points(lemma5::no_points) == Verdict::fails &&
           less(cap_ball_repaired(lemma5::no_points).squared_radius, Rational(0)) == Verdict::holds;
  });
  t.example("in R^1 a smaller ball encloses the cap", {.form = "repaired", .hypothesis = "d >= 2"}, [] {
    const auto& cap = lemma5::on_a_line;
    const auto& smaller = lemma5::point_on_a_line;
    const lemma5::Point<1> other_end = -cap.apex;
    return contains(cap, cap.apex) == Verdict::holds && contains(cap, other_end) == Verdict::fails &&
           encloses(smaller, cap.apex) == Verdict::holds && smaller.squared_radius < cap_ball_repaired(cap).squared_radius &&
           smaller.squared_radius < cap_ball_printed(cap).squared_radius;
  });
  t.example("a direction that is not perpendicular gives no witness",
            {.form = "repaired", .hypothesis = "v is perpendicular to the axis"}, [] {
              const auto made = smallest_cap_ball(lemma5::narrow, lemma5::sine_of_narrow, lemma5::slanted);
              return is_rim(lemma5::narrow, lemma5::sine_of_narrow, lemma5::slanted) == Verdict::fails &&
                     is_smallest_cap_ball(lemma5::narrow, made) == Verdict::fails;
            });
  t.example("a sine that does not belong to the cosine gives no witness", {.form = "repaired", .hypothesis = "cos^2 + sin^2 = 1"},
            [] {
              const auto made = smallest_cap_ball(lemma5::narrow, lemma5::not_its_sine, lemma5::perpendicular);
              return is_rim(lemma5::narrow, lemma5::not_its_sine, lemma5::perpendicular) == Verdict::fails &&
                     is_smallest_cap_ball(lemma5::narrow, made) == Verdict::fails;
            });
}

PROPTEST(lemma5_cap_enclosing_sphere) {
  rim_hypotheses_need_each_part(t);
  cap_hypotheses_need_each_part(t);
  checks_need_each_part(t);
  printed_ball_misses_wide_caps(t);
  repaired_ball_is_the_smallest(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_lemma5_cap_enclosing_sphere
