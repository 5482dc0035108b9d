// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/lemma3_sphere_surface_intersection.hpp"

#include "proptests/counterexamples/lemma3_sphere_surface_intersection.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/surface.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/nearest_on_surface.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_lemma3_sphere_surface_intersection {
namespace {

using namespace refitlab;

// Says whether there is a zero radius, a common center, a point on both surfaces, or a plane through the center.
template <int D>
bool is_degenerate(const gen::SurfaceAndBall<D>& c) {
  return c.surface.squared_radius == Rational(0) || c.ball.squared_radius == Rational(0) || c.surface.center == c.ball.center ||
         on_surface(c.ball, c.point) == Verdict::holds || intersection_offset(c.surface, c.ball) == Rational(0);
}

// Returns the case with the paper's surface, which has the center 0 and the radius 1.
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

// Draws a surface and a ball about different centers, with r_a > 0.
template <int D>
gen::SurfaceAndBall<D> eccentric() {
  const auto c = *gen::surface_and_ball<D>().as("case");
  RC_PRE(c.surface.center != c.ball.center && c.surface.squared_radius > Rational(0));
  return c;
}

void hypotheses_need_each_part(Suite& t) {
  t.holds("a surface meets a ball from |delta - r_a| = r_b on", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      // All of them are on one line through a, so that no root is needed.
      const auto a = *gen::rational_vector<d>().as("center");
      const auto u = *gen::sphere_point<d>().as("direction");
      const Rational radius = abs(*gen::rational().as("radius")), delta = abs(*gen::rational().as("distance"));
      const Rational edge = abs(delta - radius), amount = *gen::positive_rational().as("amount");
      const SquaredBall<Rational, d> surface{a, radius * radius};
      const gen::RationalVec<d> b = a + u * delta;
      const auto with_radius = [&](const Rational& r) { return SquaredBall<Rational, d>{b, r * r}; };
      RC_ASSERT(surface_meets_ball(surface, with_radius(edge)) == Verdict::holds);
      RC_ASSERT(surface_meets_ball(surface, with_radius(edge + amount)) == Verdict::holds);
      const Rational smaller = edge / (Rational(1) + amount);
      RC_ASSERT(surface_meets_ball(surface, with_radius(smaller)) == verdict_of(edge == Rational(0)));
      // A ball that holds all of the surface meets it.
      RC_ASSERT(surface_meets_ball(surface, with_radius(delta + radius + amount)) == Verdict::holds);
      const SquaredBall<Rational, d> none{a, -amount};
      RC_ASSERT(surface_meets_ball(none, with_radius(delta + amount)) == Verdict::fails);
      for (const Rational& r : {edge, Rational(edge + amount), smaller, Rational(delta + radius + amount)}) {
        const auto ball = with_radius(r);
        const auto made = intersection_cap(surface, ball);
        RC_ASSERT(made.verdict == verdict_of(delta != Rational(0) && r >= edge));
        RC_ASSERT(intersection_is_cap_repaired(surface, ball, gen::RationalVec<d>(a + u * radius)) == Verdict::holds);
      }
    });
  });
  needs_part_in<1, 4>(t, "b != a", [](auto d) {
    auto c = eccentric<d>();
    c.ball.center = c.surface.center;
    c.ball.squared_radius = c.surface.squared_radius + abs(*gen::rational().as("more"));
    RC_ASSERT(surface_meets_ball(c.surface, c.ball) == Verdict::holds);
    RC_ASSERT(intersection_is_cap_repaired(c.surface, c.ball, c.point) == Verdict::holds);
    RC_ASSERT(intersection_is_cap_printed(c.surface, c.ball, c.point) == Verdict::fails);
    RC_ASSERT(intersection_distance_repaired(c.surface, c.ball) == Verdict::holds);
    const auto made = intersection_cap(c.surface, c.ball);
    RC_ASSERT(is_intersection_cap(c.surface, c.ball, made) == Verdict::fails);
    return Weakening{are_eccentric(c.surface, c.ball), made.verdict};
  });
  needs_part_in<1, 4>(t, "the ball meets the surface", [](auto d) {
    auto c = eccentric<d>();
    // The ball is inside or beyond: its squared radius is less than the squared distance of the nearest point, which is at least
    // the lower end of its root.
    const Rational delta2 = squared_distance(c.surface.center, c.ball.center);
    c.ball.squared_radius = sq(Rational(delta2 - c.surface.squared_radius)) / (Rational(4) * (delta2 + c.surface.squared_radius));
    RC_PRE(delta2 != c.surface.squared_radius);
    RC_ASSERT(intersection_is_cap_repaired(c.surface, c.ball, c.point) == Verdict::holds);
    return Weakening{surface_meets_ball(c.surface, c.ball), intersection_cap(c.surface, c.ball).verdict};
  });
  needs_part_in<1, 4>(t, "the point is on the surface", [](auto d) {
    auto c = eccentric<d>();
    c.point += *gen::nonzero_vector<d>().as("shift");
    RC_PRE(on_surface(c.surface, c.point) == Verdict::fails);
    RC_ASSERT(intersection_is_cap_repaired(c.surface, c.ball, c.point) == Verdict::holds);
    RC_ASSERT(intersection_is_cap_printed(c.surface, c.ball, c.point) == Verdict::holds);
    const auto made = intersection_cap(c.surface, c.ball);
    return Weakening{on_surface(c.surface, c.point), ball_and_half_space_agree(c.ball, made.half_space, c.point)};
  });
  needs_part_in<1, 4>(t, "of the distance: e >= 0", [](auto d) {
    auto c = eccentric<d>();
    c.ball.squared_radius = c.surface.squared_radius + squared_distance(c.surface.center, c.ball.center);
    // Here e = 0: the center is in the plane, and the distance is 0.
    const auto at_center = nearest_point_of_intersection_cap(c.surface, c.ball);
    RC_ASSERT(at_center.verdict == Verdict::holds && at_center.squared_distance == Rational(0));
    RC_ASSERT(center_is_outside_half_space(c.surface, c.ball) == Verdict::fails);
    RC_ASSERT(intersection_distance_repaired(c.surface, c.ball) == Verdict::holds);
    c.ball.squared_radius += *gen::positive_rational().as("amount");
    RC_ASSERT(intersection_distance_repaired(c.surface, c.ball) == Verdict::holds);
    const auto made = nearest_point_of_intersection_cap(c.surface, c.ball);
    const auto h = intersection_cap(c.surface, c.ball).half_space;
    return Weakening{made.verdict, is_nearest_point(h, c.surface.center, made)};
  });
}

void printed_hypotheses_need_each_part(Suite& t) {
  t.holds("nothing is printed of negative squared radii, nor of a distance for r_b >= 1", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      auto c = eccentric<d>();
      const Rational amount = *gen::positive_rational().as("amount");
      auto none = c;
      none.ball.squared_radius = -amount;
      RC_ASSERT(intersection_is_cap_printed(none.surface, none.ball, none.point) == Verdict::holds);
      RC_ASSERT(intersection_distance_printed(none.ball) == Verdict::holds);
      none.ball.center = gen::RationalVec<d>::Zero();
      RC_ASSERT(intersection_distance_printed(none.ball) == Verdict::holds);
      auto wide = c;
      // A ball about 0 has no distance, and these are so large that 0 is inside H.
      for (const Rational& r2 : {Rational(1), Rational(1 + amount), Rational(2 + squared_norm(c.ball.center))}) {
        wide.ball.squared_radius = r2;
        RC_ASSERT(intersection_distance_printed(wide.ball) == Verdict::holds);
        RC_ASSERT(intersection_distance_printed(SquaredBall<Rational, d>{gen::RationalVec<d>::Zero(), r2}) == Verdict::holds);
      }
      const SquaredBall<Rational, d> concentric{gen::RationalVec<d>::Zero(), Rational(1) / (Rational(1) + amount)};
      RC_ASSERT(intersection_distance_printed(concentric) == Verdict::fails);
      // A squared radius of 0 is one.
      const SquaredBall<Rational, d> origin{gen::RationalVec<d>::Zero(), Rational(0)};
      RC_ASSERT(intersection_distance_printed(origin) == Verdict::fails);
      const SquaredBall<Rational, d> inner{c.surface.center, c.surface.squared_radius / (Rational(1) + amount)};
      RC_ASSERT(intersection_is_cap_printed(c.surface, inner, c.point) == Verdict::fails);
      const SquaredBall<Rational, d> point{c.surface.center, Rational(0)};
      RC_ASSERT(intersection_is_cap_printed(c.surface, point, c.point) == Verdict::fails);
      RC_ASSERT(intersection_is_cap_printed(point, {point.center, amount}, point.center) == Verdict::fails);
      // A surface of a negative squared radius has no points; a case that pretends one is not the theorem's.
      const SquaredBall<Rational, d> no_surface{c.surface.center, -amount};
      RC_ASSERT(intersection_is_cap_printed(no_surface, inner, c.point) == Verdict::holds);
    });
  });
}

void statements_say_their_words(Suite& t) {
  t.holds("a ball and a half-space agree on a point if both hold it, or none", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto c = *gen::surface_and_ball<d>().as("ball and point");
      auto h = (*gen::surface_in_half_space<d>().as("half-space")).half_space;
      if (*rc::gen::arbitrary<bool>().as("on the plane")) h.offset = dot(c.point, h.normal);
      const bool in_ball = squared_distance(c.point, c.ball.center) <= c.ball.squared_radius;
      const bool in_half_space = dot(c.point, h.normal) >= h.offset;
      RC_CLASSIFY(in_ball && !in_half_space, "only in the ball");
      RC_CLASSIFY(!in_ball && in_half_space, "only in the half-space");
      RC_ASSERT(ball_and_half_space_agree(c.ball, h, c.point) == verdict_of(in_ball == in_half_space));
    });
  });
}

// Checks statements with intervals that cannot decide one part alone. In exact numbers a true statement could lose that part
// unseen.
void undecided_parts_are_not_lost(Suite& t) {
  t.example("what an interval cannot decide of one part of a conclusion, it cannot decide of the statement", {}, [] {
    using Point = Vec<Interval, 2>;
    const Interval zero(0), one(1), about_one(1 - 1e-3, 1 + 1e-3), about_five(5 - 1e-3, 5 + 1e-3);
    const Point left(-one, zero), up(zero, one);
    const SquaredBall<Interval, 2> circle{Point(zero, zero), one};
    const SquaredBall<Interval, 2> touching{Point(Interval(2), zero), about_one};
    const SquaredBall<Interval, 2> through_top{Point(Interval(2), zero), about_five};
    const SquaredBall<Interval, 2> third{Point(Interval(3), zero), lift<Interval>(Rational(1, 3))};
    // This asks whether they meet.
    return Checked(intersection_is_cap_repaired(circle, touching, left) == Verdict::undecided &&
                       intersection_is_cap_repaired(circle, through_top, up) == Verdict::undecided &&
                       intersection_is_cap_repaired(circle, through_top, left) == Verdict::holds &&
                       intersection_is_cap_printed(circle, through_top, up) == Verdict::undecided &&
                       intersection_is_cap_printed(circle, through_top, left) == Verdict::holds &&
                       // This asks whether the distance is equal.
                       intersection_distance_repaired(circle, third) == Verdict::undecided &&
                       intersection_distance_printed(third) == Verdict::undecided,
                   7);
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("a half-space that is wrong in one coordinate or at the origin alone is rejected", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto c = eccentric<d>();
      const Rational amount = *gen::positive_rational().as("amount");
      const int i = *rc::gen::inRange(0, int(d)).as("coordinate");
      auto coordinate = intersection_cap(c.surface, c.ball), origin = coordinate;
      // It is right at the origin and at the other coordinate vectors.
      coordinate.half_space.normal[i] += amount;
      RC_PRE(is_half_space(coordinate.half_space) == Verdict::holds);
      RC_ASSERT(is_intersection_cap(c.surface, c.ball, coordinate) == Verdict::fails);
      // It is right at all of the coordinate vectors.
      origin.half_space.offset += amount;
      for (int k = 0; k < int(d); ++k) origin.half_space.normal[k] += amount;
      RC_PRE(is_half_space(origin.half_space) == Verdict::holds);
      RC_ASSERT(is_intersection_cap(c.surface, c.ball, origin) == Verdict::fails);
    });
  });
  t.holds("a nearest point that is wrong in one part is rejected", {.number_type = "rational", .cases = 2000}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      using Vector = gen::RationalVec<d>;
      const auto from = *gen::rational_vector<d>().as("from");
      const Rational amount = *gen::positive_rational().as("amount");
      const int i = *rc::gen::inRange(0, int(d)).as("coordinate");
      HalfSpace<Rational, d> h{*gen::nonzero_vector<d>().as("normal"), Rational(0)};
      const auto verdict = [&](const Vector& way, const Rational& squared) {
        return is_nearest_point(h, from, FootPoint<Rational, d>{Verdict::holds, from + way, squared});
      };
      const auto through = [&](const Vector& way) { h.offset = dot(Vector(from + way), h.normal); };
      const Vector way = h.normal * amount, none = Vector::Zero();
      const Rational square = squared_norm(way);
      through(way);
      RC_ASSERT(verdict(way, square) == Verdict::holds);
      // The distance is wrong.
      RC_ASSERT(verdict(way, square + amount) == Verdict::fails && verdict(way, square / 2) == Verdict::fails);
      // These are not in the plane.
      const Vector farther = way * Rational(2), nearer = way / Rational(2);
      RC_ASSERT(verdict(farther, squared_norm(farther)) == Verdict::fails);
      RC_ASSERT(verdict(nearer, squared_norm(nearer)) == Verdict::fails);
      through(-way);  // behind
      RC_ASSERT(verdict(-way, square) == Verdict::fails);
      through(none);  // in the plane
      RC_ASSERT(verdict(none, Rational(0)) == Verdict::holds);
      // This is another point of the plane: aside along one coordinate, with a normal along another.
      if constexpr (d > 1) {
        const int j = (i + *rc::gen::inRange(1, int(d)).as("other coordinate")) % d;
        h.normal = Vector::Zero();
        h.normal[i] = amount;
        Vector aside = h.normal;
        aside[j] = amount;
        through(aside);
        RC_ASSERT(verdict(aside, squared_norm(aside)) == Verdict::fails);
      }
      h = {none, Rational(0)};  // There is no half-space.
      RC_ASSERT(verdict(none, Rational(0)) == Verdict::fails);
    });
  });
}

void printed_statements_are_refuted(Suite& t) {
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
  t.refuted("for r_b < 1 the printed formula is the distance from 0 to H", {.form = "printed", .number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      RC_ASSERT(intersection_distance_printed((*gen::surface_and_ball<d>().as("case")).ball) == Verdict::holds);
    });
  });
}

void repaired_statements_hold(Suite& t) {
  using namespace lemma3;
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
  t.holds("for b = a the ball holds all of the surface or nothing of it", {.form = "repaired", .number_type = "rational"}, [] {
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
}

void verdicts_and_witnesses_are_checked(Suite& t) {
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
        // This is another point of the plane, with its own distance.
        default:
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
}

void pinned_cases(Suite& t) {
  using namespace lemma3;
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
  t.example("for r_b^2 > 1 + b^2 the distance is 0, not the formula's", {.form = "repaired", .hypothesis = "r_b^2 <= 1 + b^2"},
            [] {
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

PROPTEST(lemma3_sphere_surface_intersection) {
  undecided_parts_are_not_lost(t);
  hypotheses_need_each_part(t);
  printed_hypotheses_need_each_part(t);
  statements_say_their_words(t);
  checks_need_each_part(t);
  printed_statements_are_refuted(t);
  repaired_statements_hold(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_lemma3_sphere_surface_intersection
