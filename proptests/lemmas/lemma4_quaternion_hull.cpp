// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/lemma4_quaternion_hull.hpp"

#include "proptests/counterexamples/lemma4_quaternion_hull.hpp"
#include "proptests/gen/cap_angle.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/hull.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_lemma4_quaternion_hull {
namespace {

using namespace refitlab;

// Says whether the blend is 0 or one of the vectors, the plane passes through 0, or the ball's radius or center is 0.
template <int D>
bool is_degenerate(const gen::EnclosedHull<D>& hull) {
  bool weight_vertex = false;
  for (const Rational& w : hull.weights) weight_vertex = weight_vertex || w == Rational(1);
  return weight_vertex || squared_norm(combine<Rational, D>(hull.weights, hull.units)) == Rational(0) ||
         scaled_distance(hull.ball.center, hull.ball.squared_radius) == Rational(0) || hull.ball.squared_radius == Rational(0) ||
         squared_norm(hull.ball.center) == Rational(0);
}

const auto direction_enclosed = [](const auto& ball, const auto& units, const auto& weights) {
  return hull_element(ball, units, weights).verdict;
};
const auto rotation_enclosed = [](const auto& ball, const auto& blend) { return rotation_is_enclosed(ball, blend); };
const auto keeps_hulls = [](const auto& ball) { return ball_keeps_hulls(ball); };

// Draws three or four unit vectors in a ball that bounds hulls, so that there is one between the first and the last.
template <int D>
gen::EnclosedHull<D> several_enclosed() {
  gen::EnclosedHull<D> hull;
  hull.units = *gen::sphere_points<D>(3, 4).as("units");
  hull.weights = *gen::convex_weights(static_cast<int>(hull.units.size())).as("weights");
  // They are on one side, so that a small ball holds them.
  for (auto& n : hull.units)
    if (dot(n, hull.units[0]) < Rational(0)) n = -n;
  hull.ball.center = (hull.units[0] + hull.units[1] + hull.units[2]) / Rational(3);
  for (const auto& n : hull.units)
    hull.ball.squared_radius = max_of(hull.ball.squared_radius, squared_distance(n, hull.ball.center));
  RC_PRE(ball_keeps_hulls(hull.ball) == Verdict::holds);
  return hull;
}

// Returns the weights of the blend, or all of the weight on one vector.
template <int D>
std::vector<Rational> weights_towards(const gen::EnclosedHull<D>& hull, std::size_t k) {
  if (*rc::gen::arbitrary<bool>().as("the hull's weights")) return hull.weights;
  std::vector<Rational> weights(hull.units.size(), Rational(0));
  weights[k] = 1;
  return weights;
}

// Asserts that the statements say nothing of a case.
template <int D>
void says_nothing(const gen::EnclosedHull<D>& hull, const std::vector<Rational>& weights) {
  RC_ASSERT(hull_stays_in_cap_repaired(hull.ball, hull.units, weights) == Verdict::holds);
  RC_ASSERT(rotations_stay_in_cap_repaired(hull.ball, hull.units, weights) == Verdict::holds);
  RC_ASSERT(hull_stays_in_cap_printed(hull.ball, hull.units, weights) == Verdict::holds);
  RC_ASSERT(rotations_stay_in_cap_printed(hull.ball, hull.units, weights) == Verdict::holds);
  RC_ASSERT(hull_hypotheses_printed(hull.ball, hull.units, weights) == Verdict::fails);
}

void hypotheses_need_each_part(Suite& t) {
  needs_part_in<2, 4>(t, "one of the vectors is longer or shorter than 1, the others are units", [](auto d) {
    // The others are along the center, far from 0 or not; the odd one is to the side, on the surface of the ball.
    const auto frame = *gen::perpendicular_pair<d>().as("frame");
    const Rational more = *gen::positive_rational().as("more");
    const auto k = *rc::gen::inRange<std::size_t>(0, 4).as("which");
    gen::EnclosedHull<d> hull;
    hull.units.assign(4, frame.first);
    Rational distance;
    if (*rc::gen::arbitrary<bool>().as("longer")) {
      const auto angle = *gen::cap_angle().as("angle");
      RC_PRE(Rational(0) < angle.cosine && angle.cosine < Rational(1));
      hull.units[k] = frame.first + frame.second * (angle.sine / angle.cosine);
      distance = (Rational(1) + Rational(1) / angle.cosine) / (Rational(2) * angle.cosine) + more;
    } else {
      hull.units[k] = frame.second / (Rational(1) + more);
      distance = Rational(1, 2) + more;
    }
    hull.ball.center = frame.first * distance;
    hull.ball.squared_radius = squared_distance(hull.units[k], hull.ball.center);
    for (const auto& n : hull.units) RC_ASSERT(encloses(hull.ball, n) == Verdict::holds);
    RC_ASSERT(ball_keeps_hulls(hull.ball) == Verdict::holds);
    hull.weights = *gen::convex_weights(4).as("weights");
    const auto weights = weights_towards<d>(hull, k);
    says_nothing<d>(hull, weights);
    return Weakening{are_units_enclosed(hull.ball, hull.units),
                     direction_is_enclosed(hull.ball, combine<Rational, d>(weights, hull.units))};
  });
  needs_part_in<1, 4>(
      t, "one of the vectors is not in the ball, the others are",
      [](auto d) {
        auto hull = several_enclosed<d>();
        const auto k = *rc::gen::inRange<std::size_t>(0, hull.units.size()).as("which");
        hull.units[k] = *gen::sphere_point<d>().as("another vector");
        RC_PRE(encloses(hull.ball, hull.units[k]) == Verdict::fails);
        const auto weights = weights_towards<d>(hull, k);
        const auto b = combine<Rational, d>(weights, hull.units);
        RC_PRE(b != gen::RationalVec<d>::Zero());
        says_nothing<d>(hull, weights);
        return Weakening{are_units_enclosed(hull.ball, hull.units), rotation_is_enclosed(hull.ball, b)};
      },
      300);
  needs_part_in<2, 4>(
      t, "the weights are convex",
      [](auto d) {
        const auto hull = several_enclosed<d>();
        auto weights = hull.weights;
        const auto k = *rc::gen::inRange<std::size_t>(0, weights.size()).as("which");
        const Rational amount = *gen::positive_rational().as("amount");
        weights[(k + 1) % weights.size()] += weights[k] + amount;
        weights[k] = -amount;
        const auto b = combine<Rational, d>(weights, hull.units);
        RC_PRE(b != gen::RationalVec<d>::Zero());
        says_nothing<d>(hull, weights);
        return Weakening{is_convex<Rational>(weights), rotation_is_enclosed(hull.ball, b)};
      },
      300);
}

void hypotheses_hold_up_to_their_edges(Suite& t) {
  t.holds("no vectors are in no ball; vectors on the surface of theirs are in it", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      auto hull = *gen::enclosed_hull<d>().as("case");
      RC_ASSERT(are_units_enclosed(hull.ball, VecList<Rational, d>{}) == Verdict::fails);
      const auto k = *rc::gen::inRange<std::size_t>(0, hull.units.size()).as("which");
      const VecList<Rational, d> one{hull.units[k]};
      hull.ball.squared_radius = squared_distance(one[0], hull.ball.center);
      RC_ASSERT(are_units_enclosed(hull.ball, one) == Verdict::holds);
    });
  });
  t.holds("a ball keeps hulls up to r^2 = 1 + c^2 and from r = 1 + c on, and nowhere between", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto u = *gen::sphere_point<d>().as("direction");
      const Rational c = *gen::positive_rational().as("distance"), amount = *gen::positive_rational().as("amount");
      const Rational half = Rational(1) + c * c, whole = sq(Rational(Rational(1) + c));
      const auto keeps = [&](const Rational& square) { return ball_keeps_hulls(SquaredBall<Rational, d>{u * c, square}); };
      RC_ASSERT(keeps(half) == Verdict::holds && keeps(half - amount) == Verdict::holds);
      RC_ASSERT(keeps(whole) == Verdict::holds && keeps(whole + amount) == Verdict::holds);
      const Rational share = Rational(1) / (Rational(1) + amount);
      RC_ASSERT(keeps(half + (whole - half) * share) == Verdict::fails);
      // The printed border is another: at r = 1 it is already passed.
      RC_ASSERT(radius_below_one_is_needed_printed(SquaredBall<Rational, d>{u * c, Rational(1)}) == Verdict::fails);
      RC_ASSERT(radius_below_one_is_needed_printed(SquaredBall<Rational, d>{u * c, share}) == Verdict::holds);
    });
  });
  t.holds("the printed hypotheses are those of a radius strictly below 1", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      auto hull = *gen::enclosed_hull<d>().as("case");
      RC_ASSERT(hull_hypotheses_printed(hull.ball, hull.units, hull.weights) ==
                verdict_of(hull.ball.squared_radius < Rational(1)));
      // At 1 a blend may be 0, namely that of two opposite vectors about the origin.
      const VecList<Rational, d> opposite{hull.units[0], -hull.units[0]};
      const SquaredBall<Rational, d> unit{gen::RationalVec<d>::Zero(), Rational(1)};
      RC_ASSERT(hull_hypotheses_printed(unit, opposite, lemma4::halves) == Verdict::fails);
      RC_ASSERT(hull_stays_in_cap_printed(unit, opposite, lemma4::halves) == Verdict::holds);
      RC_ASSERT(hull_stays_in_cap_repaired(unit, opposite, lemma4::halves) == Verdict::holds);
    });
  });
}

// Checks statements with intervals that cannot decide one part alone. In exact numbers a true statement could lose that part
// unseen.
void undecided_parts_are_not_lost(Suite& t) {
  t.example("what an interval cannot decide of one part of a conclusion, it cannot decide of the statement", {}, [] {
    using Point = Vec<Interval, 2>;
    const Interval zero(0), one(1), half(0.5), about_one(1 - 1e-3, 1 + 1e-3), about_two(2 - 1e-3, 2 + 1e-3);
    const Point origin(zero, zero), right(one, zero), left(-one, zero), up(zero, one);
    const VecList<Interval, 2> opposite{right, left}, only_up{up}, only_right{right};
    return hull_stays_in_cap_repaired<Interval, 2>({up, about_two}, opposite, {half, half}) == Verdict::undecided &&
           hull_stays_in_cap_repaired<Interval, 2>({right, about_two}, only_up, {one}) == Verdict::undecided &&
           hull_stays_in_cap_printed<Interval, 2>({origin, about_one}, only_right, {one}) == Verdict::undecided;
  });
}

void checks_need_each_part(Suite& t) {
  t.holds("a direction or a rotation is enclosed if its unit vectors are", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      using Vector = gen::RationalVec<d>;
      const Vector u = *gen::sphere_point<d>().as("direction"), b = u * *gen::positive_rational().as("length");
      SquaredBall<Rational, d> ball{*gen::rational_vector<d>().as("center"), abs(*gen::rational().as("squared radius"))};
      if (*rc::gen::arbitrary<bool>().as("on the surface")) ball.squared_radius = squared_distance(u, ball.center);
      const Vector opposite = -u;
      const bool ahead = squared_distance(u, ball.center) <= ball.squared_radius;
      const bool behind = squared_distance(opposite, ball.center) <= ball.squared_radius;
      RC_CLASSIFY(scaled_distance(ball.center, ball.squared_radius) < Rational(0), "more than half of the surface");
      RC_CLASSIFY(ahead != behind, "one of both");
      RC_ASSERT(direction_is_enclosed(ball, b) == verdict_of(ahead));
      RC_ASSERT(rotation_is_enclosed(ball, b) == verdict_of(ahead || behind));
    });
  });
  t.holds("a blend that is wrong in one part is rejected", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      using Vector = gen::RationalVec<d>;
      const Vector u = *gen::sphere_point<d>().as("unit");
      const Rational amount = *gen::positive_rational().as("amount"), longer = Rational(1) + amount;
      const int i = *rc::gen::inRange(0, int(d)).as("coordinate");
      const auto verdict = [&](const SquaredBall<Rational, d>& ball, const Vector& unit, const Vector& blend) {
        return is_hull_element(ball, VecList<Rational, d>{unit}, {Rational(1)},
                               HullElement<Rational, d>{Verdict::holds, blend, dot(blend, ball.center)});
      };
      const SquaredBall<Rational, d> point{u, Rational(0)}, opposite{-u, Rational(0)}, origin{Vector::Zero(), Rational(1)};
      // Both the length and the offset hold with equality.
      RC_ASSERT(verdict(point, u, u) == Verdict::holds);
      RC_ASSERT(verdict(point, u * longer, u * longer) == Verdict::fails);  // the length
      RC_ASSERT(verdict(opposite, u, u) == Verdict::fails);                 // the offset
      Vector mirrored = u;
      mirrored[i] = -mirrored[i];
      RC_ASSERT(verdict(origin, u, u) == Verdict::holds);
      RC_ASSERT(verdict(origin, u, mirrored) == verdict_of(u[i] == Rational(0)));  // one coordinate
    });
  });
}

void printed_statements_are_compared(Suite& t) {
  using namespace lemma4;
  t.example("a mean ball of radius 6/5 bounds its hull: a radius below 1 is not needed", {.form = "printed"}, [] {
    const Disc& disc = mean_of_three_and_one;
    const Q o = scaled_distance(disc.center, disc.squared_radius), d_H_squared = o * o / (Q(4) * squared_norm(disc.center));
    return are_units_enclosed(disc, three_and_one) == Verdict::holds && d_H_squared == Q(1, 325) &&
           radius_below_one_is_needed_printed(disc) == Verdict::fails && ball_keeps_hulls(disc) == Verdict::holds &&
           hull_stays_in_cap_repaired(disc, three_and_one, quarters) == Verdict::holds;
  });

  t.holds("a ball of radius below 1 around unit vectors holds the directions of all blends, and no blend is 0",
          {.form = "printed", .number_type = "rational", .cases = 2000, .degenerate_at_least = 0.1, .degenerate_at_most = 0.9},
          [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto hull = *gen::enclosed_hull<d>().as("case");
              RC_PRE(hull_hypotheses_printed(hull.ball, hull.units, hull.weights) == Verdict::holds);
              RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
              RC_ASSERT(hull_stays_in_cap_printed(hull.ball, hull.units, hull.weights) == Verdict::holds);
              RC_ASSERT(rotations_stay_in_cap_printed(hull.ball, hull.units, hull.weights) == Verdict::holds);
            });
          });
  t.refuted("only a ball of radius below 1 bounds hulls (why section 4.3 falls back on all of S_3)",
            {.form = "implied", .number_type = "rational"}, [] {
              gen::for_some_dimension<2, 4>([](auto d) {
                const auto hull = *gen::enclosed_hull<d>().as("case");
                RC_ASSERT(radius_below_one_is_needed_printed(hull.ball) == Verdict::holds);
              });
            });
}

void repaired_statements_hold(Suite& t) {
  using namespace lemma4;
  t.holds("with r^2 <= 1 + c^2, or all of the surface, a ball around unit vectors holds the directions of all blends",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.3, .degenerate_at_most = 0.9},
          [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto hull = *gen::enclosed_hull<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
              RC_ASSERT(are_units_enclosed(hull.ball, hull.units) == Verdict::holds);
              RC_ASSERT(hull_stays_in_cap_repaired(hull.ball, hull.units, hull.weights) == Verdict::holds);
              // The hypothesis c != 0 is not needed.
              if (scaled_distance(hull.ball.center, hull.ball.squared_radius) > Rational(0))
                RC_ASSERT(hull.ball.center != gen::RationalVec<d>::Zero());
              if (ball_keeps_hulls(hull.ball) != Verdict::holds) return;
              RC_CLASSIFY(hull.ball.squared_radius >= Rational(1), "radius of 1 or more");
              const auto made = hull_element(hull.ball, hull.units, hull.weights);
              RC_ASSERT(made.verdict == Verdict::holds);
              RC_ASSERT(is_hull_element(hull.ball, hull.units, hull.weights, made) == Verdict::holds);
            });
          });
  t.holds("every other ball fails for two unit vectors and their middle",
          {.form = "repaired", .number_type = "rational", .cases = 2000}, [] {
            gen::for_some_dimension<2, 4>([](auto d) {
              const auto frame = *gen::perpendicular_pair<d>().as("frame");
              const Rational distance = *gen::positive_rational().as("distance");
              const auto angle = *gen::cap_angle().as("angle");
              RC_PRE(angle.cosine < Rational(0) && angle.sine > Rational(0));
              const Rational square = Rational(1) + distance * distance - Rational(2) * distance * angle.cosine;
              const SquaredBall<Rational, d> ball{frame.first * distance, square};
              const VecList<Rational, d> units{frame.first * angle.cosine + frame.second * angle.sine,
                                               frame.first * angle.cosine - frame.second * angle.sine};
              RC_ASSERT(are_units_enclosed(ball, units) == Verdict::holds);
              RC_ASSERT(ball_keeps_hulls(ball) == Verdict::fails);
              RC_ASSERT(hull_element(ball, units, halves).verdict == Verdict::fails);
              RC_ASSERT(is_hull_element(ball, units, halves, hull_element(ball, units, halves)) == Verdict::fails);
              // It says nothing of such a ball.
              RC_ASSERT(hull_stays_in_cap_repaired(ball, units, halves) == Verdict::holds);
              RC_ASSERT(rotations_stay_in_cap_repaired(ball, units, halves) == Verdict::holds);
            });
          });
  t.holds(
      "Corollary 1: any ball around unit quaternions holds the rotations of all blends",
      {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.3, .degenerate_at_most = 0.9}, [] {
        gen::for_some_dimension<1, 4>([](auto d) {
          const auto hull = *gen::enclosed_hull<d>().as("case");
          RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
          RC_CLASSIFY(scaled_distance(hull.ball.center, hull.ball.squared_radius) < Rational(0), "more than half of the surface");
          RC_ASSERT(rotations_stay_in_cap_repaired(hull.ball, hull.units, hull.weights) == Verdict::holds);
        });
      });
  t.holds("the squared form says what the normalised blend does", {.form = "repaired", .number_type = "exact root", .cases = 150},
          [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto hull = *gen::enclosed_hull<d>().as("case");
              const auto b = combine<Rational, d>(hull.weights, hull.units);
              RC_PRE(b != gen::RationalVec<d>::Zero());
              const auto ball = lift<ExactRoot>(hull.ball);
              const auto direction = direction_by_root(lift<ExactRoot>(b));
              const Vec<ExactRoot, d> opposite = -direction;
              RC_ASSERT((encloses(ball, direction) == direction_is_enclosed(hull.ball, b)));
              RC_ASSERT(((encloses(ball, direction) | encloses(ball, opposite)) == rotation_is_enclosed(hull.ball, b)));
            });
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("intervals never contradict the exact verdict on balls, directions and rotations",
          {.number_type = "interval", .cases = 2000, .degenerate_at_least = 0.3, .degenerate_at_most = 0.9}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto hull = *gen::enclosed_hull<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
              hull.ball.squared_radius += *gen::nudge().as("nudge of the squared radius");
              decide_by_all(direction_enclosed, hull.ball, hull.units, hull.weights);
              decide_by_all(rotation_enclosed, hull.ball, combine<Rational, d>(hull.weights, hull.units));
              decide_by_all(keeps_hulls, hull.ball);
            });
          });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .degenerate_at_least = 0.3, .degenerate_at_most = 0.9},
          [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto hull = *gen::enclosed_hull<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
              const Rational amount = *gen::positive_rational().as("amount");
              const auto shift = *gen::nonzero_vector<d>().as("shift");
              auto bad = hull_element(hull.ball, hull.units, hull.weights);
              switch (*rc::gen::inRange(0, 3).as("mutation")) {
                case 0:
                  bad.blend += shift;
                  bad.along = dot(bad.blend, hull.ball.center);
                  break;
                case 1: bad.along += amount; break;
                default: bad.along -= amount;
              }
              RC_ASSERT(is_hull_element(hull.ball, hull.units, hull.weights, bad) == Verdict::fails);
            });
          });
}

void pinned_cases(Suite& t) {
  using namespace lemma4;
  t.example("a ball of more than half of the surface loses a direction, but not its rotation",
            {.form = "repaired", .hypothesis = "r^2 <= 1 + c^2"}, [] {
              bool all = true;
              for (const auto& [disc, units] : {std::pair{around_behind, behind}, {around_left_and_down, left_and_down}})
                all = all && are_units_enclosed(disc, units) == Verdict::holds && ball_keeps_hulls(disc) == Verdict::fails &&
                      hull_element(disc, units, halves).verdict == Verdict::fails &&
                      rotations_stay_in_cap_repaired(disc, units, halves) == Verdict::holds;
              return Checked(all, 2);
            });
  t.example("the mean ball of 1, 1, 1 and a wide turn has a negative d_H: it bounds rotations, but not directions",
            {.form = "repaired", .hypothesis = "r^2 <= 1 + c^2"}, [] {
              const Disc& disc = mean_of_three_and_wide;
              return are_units_enclosed(disc, three_and_wide) == Verdict::holds &&
                     scaled_distance(disc.center, disc.squared_radius) == Q(-7, 10) && ball_keeps_hulls(disc) == Verdict::fails &&
                     rotations_stay_in_cap_repaired(disc, three_and_wide, quarters) == Verdict::holds;
            });
  t.example("at r^2 = 1 + c^2 a blend may be 0", {.form = "repaired", .hypothesis = "r^2 < 1 + c^2"}, [] {
    return are_units_enclosed(around_up_and_down, up_and_down) == Verdict::holds &&
           scaled_distance(around_up_and_down.center, around_up_and_down.squared_radius) == Q(0) &&
           squared_norm(combine<Q, 2>(halves, up_and_down)) == Q(0) &&
           hull_stays_in_cap_repaired(around_up_and_down, up_and_down, halves) == Verdict::holds;
  });
  t.example("a vector that is not of unit length is in the ball, its direction is not",
            {.form = "repaired", .hypothesis = "the n_i are unit vectors"}, [] {
              return encloses(only_not_unit, not_unit[0]) == Verdict::holds &&
                     ball_keeps_hulls(only_not_unit) == Verdict::holds &&
                     hull_element(only_not_unit, not_unit, alone).verdict == Verdict::fails &&
                     rotation_is_enclosed(only_not_unit, not_unit[0]) == Verdict::fails;
            });
  t.example("a ball bounds only what it holds", {.form = "repaired", .hypothesis = "the n_i are in the ball"}, [] {
    return ball_keeps_hulls(only_right) == Verdict::holds && are_units_enclosed(only_right, up) == Verdict::fails &&
           hull_element(only_right, up, alone).verdict == Verdict::fails &&
           rotation_is_enclosed(only_right, up[0]) == Verdict::fails;
  });
  t.example("weights that are not convex leave the cap", {.form = "repaired", .hypothesis = "w is in W_m"}, [] {
    const auto made = hull_element(mean_of_right_and_up, right_and_up, not_convex);
    return are_units_enclosed(mean_of_right_and_up, right_and_up) == Verdict::holds &&
           ball_keeps_hulls(mean_of_right_and_up) == Verdict::holds && made.verdict == Verdict::fails &&
           is_hull_element(mean_of_right_and_up, right_and_up, not_convex, made) == Verdict::fails &&
           rotation_is_enclosed(mean_of_right_and_up, made.blend) == Verdict::fails;
  });
}

PROPTEST(lemma4_quaternion_hull) {
  undecided_parts_are_not_lost(t);
  hypotheses_need_each_part(t);
  hypotheses_hold_up_to_their_edges(t);
  checks_need_each_part(t);
  printed_statements_are_compared(t);
  repaired_statements_hold(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_lemma4_quaternion_hull
