#include "lemmas/s43_minkowski_sum.hpp"

#include "proptests/counterexamples/s43_minkowski_sum.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using Point = Vec<Rational, 3>;

// A blend, a ball, a pivot, and a vector no longer than the radius.
struct TurnedBall {
  Quaternion<Rational> blend = *gen::nonzero_vector<4>();
  Ball3<Rational> ball{*gen::rational_vector<3>(),
                       *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::positive_rational(), gen::positive_rational())};
  Point pivot = *gen::rational_vector<3>();
  Point offset = *gen::sphere_point<3>() * (ball.radius * *gen::unit_interval_rational());

  TurnedBall() {
    RC_CLASSIFY(ball.radius == Rational(0) || squared_norm(offset) == sq(ball.radius) || pivot == ball.center ||
                    blend[0] == Rational(0),
                "degenerate");
  }
  auto turned() const { return turned_ball_in_sum<Rational>(blend, ball, pivot, ball.center + offset); }
  auto summed() const { return sum_in_turned_ball<Rational>(blend, ball, pivot, offset); }
};

PROPTEST(s43_minkowski_sum) {
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
  t.holds("a turn keeps scalar products and handedness, and only a zero blend is refused", {.number_type = "rational"},
          [] {
            const Quaternion<Rational> q = *gen::nonzero_vector<4>();
            const Point x = *gen::rational_vector<3>(), y = *gen::rational_vector<3>();
            const Point turned_x = rotate_by(q, x), turned_y = rotate_by(q, y);
            RC_ASSERT(dot(turned_x, turned_y) == dot(x, y));
            RC_ASSERT(cross(turned_x, turned_y) == rotate_by<Rational>(q, cross(x, y)));
          });

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
    // Both moved alike: the sum is right, the point is not in the ball.
    auto both = c.turned().witness;
    const Point far = *gen::sphere_point<3>() * (Rational(2) * c.ball.radius + Rational(1));
    both.point += far;
    both.offset += rotate_by(c.blend, far);
    both.turned_point += rotate_by(c.blend, far);
    RC_ASSERT(rejected(both));
  });

  const Options non_zero{.form = "printed", .hypothesis = "the blend is not 0"};
  t.example("for the zero blend every point is an image, so an offset may be longer than the radius", non_zero, [] {
    using namespace s43_minkowski;
    const Point center = unit_ball.center;
    return minkowski_sum_hypotheses(zero_blend) == Verdict::fails &&
           is_rotated(zero_blend, center, center) == Verdict::holds &&
           is_rotated(zero_blend, center, anywhere) == Verdict::holds &&
           is_turned_point(zero_blend, unit_ball, pivot, {center, anywhere, center, anywhere}) == Verdict::fails &&
           is_turned_point(zero_blend, unit_ball, pivot, {anywhere, center, center, center}) == Verdict::fails;
  });
  const Options is_ball{.form = "printed", .hypothesis = "S is a ball"};
  t.example("a turned box is not the box about the turned center", is_ball, [] {
    const Point turned = rotate_by(s43_minkowski::turn, s43_minkowski::box_corner);
    return turned == Point(Rational(-1, 5), Rational(7, 5), 1);
  });
}

}  // namespace
}  // namespace proptests
