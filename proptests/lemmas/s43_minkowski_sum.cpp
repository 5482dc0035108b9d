// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s43_minkowski_sum.hpp"

#include "proptests/counterexamples/s43_minkowski_sum.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_s43_minkowski_sum {
namespace {

using namespace refitlab;
using Point = Vec<Rational, 3>;

// Draws a blend, a ball, a pivot, and a vector no longer than the radius.
struct TurnedBall {
  Quaternion<Rational> blend = *gen::nonzero_vector<4>();
  Ball3<Rational> ball{*gen::rational_vector<3>(),
                       *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::positive_rational(), gen::positive_rational())};
  Point pivot = *gen::rational_vector<3>();
  Point offset = *gen::sphere_point<3>() * (ball.radius * *gen::unit_interval_rational());

  TurnedBall() {
    RC_CLASSIFY(
        ball.radius == Rational(0) || squared_norm(offset) == sq(ball.radius) || pivot == ball.center || blend[0] == Rational(0),
        "degenerate");
  }
  auto turned() const { return turned_ball_in_sum<Rational>(blend, ball, pivot, ball.center + offset); }
  auto summed() const { return sum_in_turned_ball<Rational>(blend, ball, pivot, offset); }
};

// Returns the turned point by the product of quaternions, for comparison with the relation and the formula of a turn.
Point by_products(const Quaternion<Rational>& q, const Point& x) {
  const Quaternion<Rational> pure(0, x[0], x[1], x[2]);
  return imaginary(multiply(multiply(q, pure), conjugate(q))) / squared_norm(q);
}

void hypotheses_need_each_part(Suite& t) {
  t.holds("a blend is a rotation as soon as one of its coordinates is not 0", {.number_type = "rational"}, [] {
    Quaternion<Rational> q = Quaternion<Rational>::Zero();
    RC_ASSERT(minkowski_sum_hypotheses(q) == Verdict::fails);
    const Rational amount = *gen::positive_rational().as("amount");
    q[*rc::gen::inRange(0, 4).as("coordinate")] = *rc::gen::element(amount, Rational(-amount)).as("value");
    RC_ASSERT(minkowski_sum_hypotheses(q) == Verdict::holds);
  });
  needs_part(t, "the blend is not 0", [] {
    TurnedBall c;
    c.blend = Quaternion<Rational>::Zero();
    // Every point is an image: that of a center need not be as far from that of a point as they are.
    const Point center = *gen::rational_vector<3>().as("image of the center");
    const Point point = *gen::rational_vector<3>().as("image of the point");
    RC_ASSERT(is_rotated<Rational>(c.blend, c.ball.center - c.pivot, center) == Verdict::holds);
    RC_ASSERT(is_rotated<Rational>(c.blend, c.offset, point) == Verdict::holds);
    const TurnedPoint<Rational> witness{c.ball.center + c.offset, point - center, center, point};
    return Weakening{minkowski_sum_hypotheses(c.blend), is_turned_point(c.blend, c.ball, c.pivot, witness)};
  });
  needs_part(t, "the point is in the ball, and the offset no longer than its radius", [] {
    const TurnedBall c;
    const Point far = *gen::sphere_point<3>() * (c.ball.radius + *gen::positive_rational().as("amount"));
    const Verdict turned = turned_ball_in_sum<Rational>(c.blend, c.ball, c.pivot, c.ball.center + far).verdict;
    const Verdict summed = sum_in_turned_ball<Rational>(c.blend, c.ball, c.pivot, far).verdict;
    RC_ASSERT(turned == summed);
    return Weakening{encloses<Rational, 3>(c.ball, c.ball.center + far), turned};
  });
  needs_part(t, "the radius is not negative", [] {
    TurnedBall c;
    RC_PRE(c.ball.radius > 0);
    // Its square is as large.
    c.ball.radius = -c.ball.radius;
    RC_ASSERT(c.summed().verdict == Verdict::fails);
    return Weakening{encloses<Rational, 3>(c.ball, c.ball.center + c.offset), c.turned().verdict};
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("a vector is the turned one if it is the product of quaternions, in every coordinate", {.number_type = "rational"}, [] {
    const Quaternion<Rational> q = *gen::nonzero_vector<4>();
    const Point x = *gen::rational_vector<3>();
    const Point turned = by_products(q, x);
    RC_ASSERT(rotate_by(q, x) == turned);
    RC_ASSERT(is_rotated(q, x, turned) == Verdict::holds);
    const Rational amount = *gen::positive_rational();
    Point wrong = turned;
    wrong[*rc::gen::inRange(0, 3)] += *rc::gen::element(amount, Rational(-amount));
    RC_ASSERT(is_rotated(q, x, wrong) == Verdict::fails);
  });
  t.holds("a turned point that is wrong in one part, with an offset that is short enough, is rejected",
          {.number_type = "rational"}, [] {
            TurnedBall c;
            c.ball.radius = *gen::positive_rational();
            const auto verdict = [&](const TurnedPoint<Rational>& w) { return is_turned_point(c.blend, c.ball, c.pivot, w); };
            const Point shift = *gen::sphere_point<3>() * c.ball.radius;
            auto center = turned_ball_in_sum<Rational>(c.blend, c.ball, c.pivot, c.ball.center).witness;
            auto turned = center, sum = center, point = center;
            RC_ASSERT(verdict(center) == Verdict::holds);
            center.turned_center += shift, center.offset -= shift;
            RC_ASSERT(verdict(center) == Verdict::fails);
            turned.turned_point += shift, turned.offset += shift;
            RC_ASSERT(verdict(turned) == Verdict::fails);
            sum.offset[*rc::gen::inRange(0, 3)] += *rc::gen::element(c.ball.radius, Rational(-c.ball.radius));
            RC_ASSERT(verdict(sum) == Verdict::fails);
            point.point += shift;
            RC_ASSERT(verdict(point) == Verdict::fails);
          });
  t.holds("a point and an offset of exactly the radius are accepted", {.number_type = "rational"}, [] {
    TurnedBall c;
    c.offset = *gen::sphere_point<3>() * c.ball.radius;
    RC_ASSERT(c.turned().verdict == Verdict::holds);
    RC_ASSERT(c.summed().verdict == Verdict::holds);
    RC_ASSERT(c.turned().witness.offset == by_products(c.blend, c.offset));
    RC_ASSERT(c.summed().witness.point == Point(c.ball.center + by_products(conjugate(c.blend), c.offset)));
  });
}

void turned_balls_are_sums(Suite& t) {
  t.holds("a turned point of the ball is the turned center plus an offset of at most the radius",
          {.form = "printed", .number_type = "rational", .degenerate_at_least = 0.3}, [] {
            const TurnedBall c;
            RC_ASSERT(minkowski_sum_hypotheses(c.blend) == Verdict::holds);
            const auto sum = c.turned();
            RC_ASSERT(sum.verdict == Verdict::holds);
            RC_ASSERT(is_turned_point(c.blend, c.ball, c.pivot, sum.witness) == Verdict::holds);
          });
  t.holds("the turned center plus an offset of at most the radius is a turned point of the ball",
          {.form = "printed", .number_type = "rational", .degenerate_at_least = 0.3}, [] {
            const TurnedBall c;
            const auto sum = c.summed();
            RC_ASSERT(sum.verdict == Verdict::holds);
            RC_ASSERT(sum.witness.offset == c.offset);
            RC_ASSERT(is_turned_point(c.blend, c.ball, c.pivot, sum.witness) == Verdict::holds);
          });
  t.holds("a turn keeps scalar products and handedness", {.number_type = "rational"}, [] {
    const Quaternion<Rational> q = *gen::nonzero_vector<4>();
    const Point x = *gen::rational_vector<3>(), y = *gen::rational_vector<3>();
    const Point turned_x = rotate_by(q, x), turned_y = rotate_by(q, y);
    RC_ASSERT(dot(turned_x, turned_y) == dot(x, y));
    RC_ASSERT(is_rotated<Rational>(q, cross(x, y), cross(turned_x, turned_y)) == Verdict::holds);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 400}, [] {
    const TurnedBall c;
    decide_by_all([]<class S>(const Quaternion<S>& q, const Ball3<S>& ball, const Vec<S, 3>& pivot,
                              const Vec<S, 3>& point) { return turned_ball_in_sum<S>(q, ball, pivot, point).verdict; },
                  c.blend, c.ball, c.pivot, Point(c.ball.center + c.offset * *gen::positive_rational()));
  });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .cases = 500}, [] {
    const TurnedBall c;
    const auto rejected = [&](const TurnedPoint<Rational>& w) {
      return is_turned_point(c.blend, c.ball, c.pivot, w) == Verdict::fails;
    };
    auto offset = c.turned().witness, point = offset, center = offset, turned = offset;
    const Point bump = *gen::nonzero_vector<3>();
    offset.offset += bump;
    point.point += bump;
    center.turned_center += bump;
    turned.turned_point += bump;
    RC_ASSERT(rejected(offset) && rejected(point) && rejected(center) && rejected(turned));
    // Both are moved alike: the sum is right, but the point is not in the ball.
    auto both = c.turned().witness;
    const Point far = *gen::sphere_point<3>() * (Rational(2) * c.ball.radius + Rational(1));
    both.point += far;
    both.offset += rotate_by(c.blend, far);
    both.turned_point += rotate_by(c.blend, far);
    RC_ASSERT(rejected(both));
  });
}

void pinned_cases(Suite& t) {
  t.example("for the zero blend every point is an image, so an offset may be longer than the radius",
            {.form = "printed", .hypothesis = "the blend is not 0"}, [] {
              using namespace s43_minkowski;
              const Point center = unit_ball.center;
              return minkowski_sum_hypotheses(zero_blend) == Verdict::fails &&
                     is_rotated(zero_blend, center, center) == Verdict::holds &&
                     is_rotated(zero_blend, center, anywhere) == Verdict::holds &&
                     is_turned_point(zero_blend, unit_ball, pivot, {center, anywhere, center, anywhere}) == Verdict::fails &&
                     is_turned_point(zero_blend, unit_ball, pivot, {anywhere, center, center, center}) == Verdict::fails;
            });
  t.example("a turned box is not the box about the turned center", {.form = "printed", .hypothesis = "S is a ball"}, [] {
    const Point turned(Rational(-1, 5), Rational(7, 5), 1);  // no longer in [-1, 1]^3
    const Ball3<Rational> around_box{s43_minkowski::pivot, Rational(2)};
    return is_rotated(s43_minkowski::turn, s43_minkowski::box_corner, turned) == Verdict::holds &&
           turned_ball_in_sum(s43_minkowski::turn, around_box, s43_minkowski::pivot, s43_minkowski::box_corner).verdict ==
               Verdict::holds &&
           turned_ball_in_sum(s43_minkowski::turn, s43_minkowski::unit_ball, s43_minkowski::pivot, s43_minkowski::box_corner)
                   .verdict == Verdict::fails;
  });
}

PROPTEST(s43_minkowski_sum) {
  hypotheses_need_each_part(t);
  checks_need_each_part(t);
  turned_balls_are_sums(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s43_minkowski_sum
