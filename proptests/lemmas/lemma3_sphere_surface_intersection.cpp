#include "lemmas/lemma3_sphere_surface_intersection.hpp"

#include "proptests/counterexamples/lemma3_sphere_surface_intersection.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/surface.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/nearest_on_surface.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;

// A zero radius, a common center, a point on both surfaces, or a plane through the center.
template <int D>
bool is_degenerate(const gen::SurfaceAndBall<D>& c) {
  return c.surface.squared_radius == Rational(0) || c.ball.squared_radius == Rational(0) ||
         c.surface.center == c.ball.center || on_surface(c.ball, c.point) == Verdict::holds ||
         intersection_offset(c.surface, c.ball) == Rational(0);
}

// The paper's surface has the center 0 and the radius 1.
template <int D>
gen::SurfaceAndBall<D> about_origin(const gen::SurfaceAndBall<D>& c) {
  return {{gen::RationalVec<D>::Zero(), Rational(1)}, c.ball, c.point};
}

const auto surface_meets = [](const auto& surface, const auto& ball) { return surface_meets_ball(surface, ball); };
const auto agree_on = [](const auto& surface, const auto& ball, const auto& x) {
  return ball_and_half_space_agree(ball, intersection_cap(surface, ball).half_space, x);
};
const auto is_outside = [](const auto& surface, const auto& ball) {
  return !contains(intersection_cap(surface, ball).half_space, surface.center);
};

PROPTEST(lemma3_sphere_surface_intersection) {
  using namespace lemma3;
  t.example("empty intersections and equal centers refute the printed statement", {.form = "printed"}, [] {
    bool all = true;
    for (const Disc& disc : {inside, beyond, point_inside, point_beyond, concentric_small, concentric_large})
      all = all && intersection_is_cap_printed(unit_circle, disc, on_circle) == Verdict::fails &&
            intersection_is_cap_repaired(unit_circle, disc, on_circle) == Verdict::holds;
    return Checked(all, 6);
  });
  t.example("b = 0 refutes the printed distance", {.form = "printed"}, [] {
    bool all = true;
    for (const Disc& disc : {concentric_small, point_inside})
      all = all && intersection_distance_printed(disc) == Verdict::fails &&
            intersection_distance_repaired(unit_circle, disc) == Verdict::holds;
    return Checked(all, 2);
  });

  t.refuted("a sphere's surface and a ball intersect in a cap", {.form = "printed", .number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto c = *gen::surface_and_ball<d>().as("case");
      RC_ASSERT(intersection_is_cap_printed(c.surface, c.ball, c.point) == Verdict::holds);
    });
  });
  t.refuted(
      "for r_b < 1 the printed formula is the distance from 0 to H", {.form = "printed", .number_type = "rational"},
      [] {
        gen::for_some_dimension<1, 4>([](auto d) {
          RC_ASSERT(intersection_distance_printed((*gen::surface_and_ball<d>().as("case")).ball) == Verdict::holds);
        });
      });

  t.holds("where b != a and the ball meets the surface, they have a cap in common",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.25}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto c = *gen::surface_and_ball<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
              RC_ASSERT(intersection_is_cap_repaired(c.surface, c.ball, c.point) == Verdict::holds);
              if (are_eccentric(c.surface, c.ball) != Verdict::holds) return;
              const auto made = intersection_cap(c.surface, c.ball);
              RC_ASSERT(is_intersection_cap(c.surface, c.ball, made) == Verdict::holds);
              // The surface meets the ball if and only if it meets the half-space.
              RC_ASSERT((made.verdict == surface_meets_ball(c.surface, c.ball)));
              RC_ASSERT(ball_and_half_space_agree(c.ball, made.half_space, c.point) == Verdict::holds);
            });
          });
  t.holds("for b = a the ball holds all of the surface or nothing of it",
          {.form = "repaired", .number_type = "rational"}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = *gen::surface_and_ball<d>().as("case");
              c.ball.center = c.surface.center;
              const gen::RationalVec<d> opposite = c.surface.center * Rational(2) - c.point;
              RC_ASSERT((surface_meets_ball(c.surface, c.ball) == encloses(c.ball, c.point)));
              RC_ASSERT((encloses(c.ball, opposite) == encloses(c.ball, c.point)));
            });
          });
  t.holds("0 is outside H if and only if r_b^2 < 1 + b^2, and then the printed formula is right unless b = 0",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.25}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = *gen::surface_and_ball<d>().as("case");
              if (*rc::gen::arbitrary<bool>().as("surface about 0")) c = about_origin(c);
              RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
              RC_ASSERT(intersection_distance_repaired(c.surface, c.ball) == Verdict::holds);
              const Rational b2 = squared_norm(c.ball.center);
              if (c.surface.squared_radius != Rational(1) || c.surface.center != gen::RationalVec<d>::Zero() ||
                  b2 == Rational(0) || c.ball.squared_radius > Rational(1) + b2)
                return;
              const Rational numerator = Rational(1) + b2 - c.ball.squared_radius;
              const auto nearest = nearest_point_of_intersection_cap(c.surface, c.ball);
              RC_ASSERT(nearest.squared_distance * Rational(4) * b2 == numerator * numerator);
            });
          });
  t.holds("the surface meets the ball if the surface's point nearest to b does",
          {.form = "repaired", .number_type = "exact root", .cases = 150}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = *gen::surface_and_ball<d>().as("case");
              RC_PRE(c.surface.center != c.ball.center);
              c.surface.squared_radius = *gen::positive_rational().as("squared radius");
              const auto surface = lift<ExactRoot>(c.surface);
              const auto ball = lift<ExactRoot>(c.ball);
              const Vec<ExactRoot, d> towards = ball.center - surface.center;
              RC_ASSERT((surface_meets_ball(surface, ball) == encloses(ball, point_towards<d>(surface, towards))));
            });
          });

  t.holds("intervals never contradict the exact verdict on meeting, on points and on the center",
          {.number_type = "interval", .cases = 2000, .degenerate_at_least = 0.25}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = *gen::surface_and_ball<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
              c.ball.squared_radius += *gen::nudge().as("nudge of the squared radius");
              decide_by_all(surface_meets, c.surface, c.ball);
              decide_by_all(is_outside, c.surface, c.ball);
              RC_ASSERT(decide_by_all(agree_on, c.surface, c.ball, c.point) == Verdict::holds);
            });
          });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .degenerate_at_least = 0.2}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto c = *gen::surface_and_ball<d>().as("case");
      RC_PRE(c.surface.center != c.ball.center);
      RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
      const Rational amount = *gen::positive_rational().as("amount");
      const auto shift = *gen::nonzero_vector<d>().as("shift");
      auto bad = intersection_cap(c.surface, c.ball);
      switch (*rc::gen::inRange(0, 4).as("mutation")) {
        case 0: bad.half_space.normal += shift; break;
        case 1: bad.half_space.normal = -bad.half_space.normal; break;
        case 2: bad.half_space.offset += amount; break;
        default: bad.half_space.offset -= amount;
      }
      RC_ASSERT(is_intersection_cap(c.surface, c.ball, bad) == Verdict::fails);

      const auto h = intersection_cap(c.surface, c.ball).half_space;
      auto wrong = nearest_point_of_intersection_cap(c.surface, c.ball);
      switch (*rc::gen::inRange(0, 4).as("mutation of the foot")) {
        case 0: wrong.foot += shift; break;
        case 1: wrong.squared_distance += amount; break;
        case 2: wrong.squared_distance -= amount; break;
        default:  // another point of the plane, with its own distance
          if constexpr (d == 1) {
            wrong.foot += shift;
          } else {
            gen::RationalVec<d> along = gen::RationalVec<d>::Zero();
            const int i = h.normal[0] != Rational(0) || h.normal[1] != Rational(0) ? 0 : 1;
            along[i] = -h.normal[i + 1];
            along[i + 1] = h.normal[i];
            if (along == gen::RationalVec<d>::Zero()) along[0] = 1;
            wrong.foot += along * amount;
          }
          wrong.squared_distance = squared_distance(wrong.foot, c.surface.center);
      }
      RC_ASSERT(is_nearest_point(h, c.surface.center, wrong) == Verdict::fails);
    });
  });

  t.example("for b = a there is no half-space", {.form = "repaired", .hypothesis = "b != a"}, [] {
    return are_eccentric(unit_circle, concentric_large) == Verdict::fails &&
           surface_meets_ball(unit_circle, concentric_large) == Verdict::holds &&
           intersection_cap(unit_circle, concentric_large).verdict == Verdict::fails;
  });
  t.example("a ball that does not meet the surface makes no cap", {.form = "repaired", .hypothesis = "they meet"}, [] {
    return surface_meets_ball(unit_circle, point_beyond) == Verdict::fails &&
           intersection_cap(unit_circle, point_beyond).verdict == Verdict::fails &&
           surface_meets_ball(unit_circle, inside) == Verdict::fails &&
           intersection_cap(unit_circle, inside).verdict == Verdict::fails;
  });
  t.example("for r_b^2 > 1 + b^2 the distance is 0, not the formula's",
            {.form = "repaired", .hypothesis = "r_b^2 <= 1 + b^2"}, [] {
              const auto made = nearest_point_of_intersection_cap(unit_circle, holds_most);
              const auto h = intersection_cap(unit_circle, holds_most).half_space;
              return made.verdict == Verdict::fails && contains(h, unit_circle.center) == Verdict::holds &&
                     made.squared_distance == Q(1) && is_nearest_point(h, unit_circle.center, made) == Verdict::fails;
            });
  t.example("off the surface the ball and the half-space differ",
            {.form = "repaired", .hypothesis = "the point is on the surface"}, [] {
              const auto h = intersection_cap(unit_circle, through_center).half_space;
              return ball_and_half_space_agree(through_center, h, unit_circle.center) == Verdict::fails;
            });
}

}  // namespace
}  // namespace proptests
