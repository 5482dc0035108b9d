// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the ball around all images of a vector under a hull of quaternions.
#include "lemmas/rotation_bound.hpp"

#include <random>

#include "lemmas/exact/lift.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/t3_one_cap.hpp"
#include "proptests/counterexamples/rotation_bound.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_rotation_bound {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;

struct Hull {
  std::vector<RationalQuaternion> unit;
  RationalQuaternion direction;
};

// Draws a hull with a direction as refits choose it (the mean), one of the quaternions, or any.
Hull draw(int most) {
  Hull h;
  h.unit = *gen::unit_quaternions(1, most);
  // They are within a half-sphere, so that there is something to bound.
  if (*rc::gen::inRange(0, 3) == 0)
    for (auto& q : h.unit)
      if (dot(q, h.unit[0]) < 0) q = -q;
  const int kind = *rc::gen::inRange(0, 4);
  h.direction = RationalQuaternion::Zero();
  if (kind < 2)
    for (const auto& q : h.unit) h.direction += q;
  else h.direction = kind == 2 ? h.unit.back() : *gen::nonzero_quaternion();
  return h;
}

// Returns the bound of the images of x without a root, from the lemmas: kappa^2 is rational, and so are the apex's image and the
// squared radius.
SquaredBall<Rational, 3> ball_from_lemmas(const Hull& h, const RationalVec<3>& x) {
  const std::span<const RationalQuaternion> unit(h.unit);
  for (const auto& q : h.unit)  // This holds also where the direction is 0.
    if (dot(q, h.direction) <= 0) return {RationalVec<3>::Zero(), squared_norm(x)};
  const RationalVec<3> apex = rotate_scaled<Rational>(h.direction, x) / squared_norm(h.direction);
  const Rational cosine = Rational(2) * squared_cap_cosine(unit, h.direction) - Rational(1);
  return cap_ball_repaired(Cap<Rational, 3>{RationalVec<3>::Zero(), apex, cosine});
}

template <class S>
Ball3<S> ball_from_bound(const Hull& h, const RationalVec<3>& x) {
  const auto unit = lift<S>(h.unit);
  return rotated_ball<S>(bound_rotations<S>(unit, lift<S>(h.direction)), lift<S>(x));
}

// Says whether no number of the one ball differs for sure from the other ball's. For an exact S this is certain equality.
template <class S>
Verdict same(const Ball3<S>& ball, const SquaredBall<Rational, 3>& other) {
  Verdict v = equal(sq(ball.radius), lift<S>(other.squared_radius));
  for (int i = 0; i < 3; ++i) v &= equal(ball.center[i], lift<S>(other.center[i]));
  return v;
}

bool is_degenerate(const Hull& h) {
  bool degenerate = h.unit.size() == 1 || squared_norm(h.direction) == 0;
  for (std::size_t i = 0; i < h.unit.size(); ++i) {
    degenerate = degenerate || dot(h.unit[i], h.direction) == 0;
    for (std::size_t k = 0; k < i; ++k) degenerate = degenerate || abs(dot(h.unit[i], h.unit[k])) == 1;
  }
  return degenerate;
}

// Returns sin alpha of a rotation bound from the smallest dot product d = <n, a>, as lines 13 and 15 compute it.
float sine_by_dot(std::span<const Quaternion<float>> unit, const Quaternion<float>& apex) {
  float d = 1;
  for (const auto& q : unit) d = std::min(d, dot(q, apex));
  return 2 * d * std::sqrt(std::max(0.0f, 1 - d * d));
}

void bounds_hold_the_balls_of_the_lemmas(Suite& t) {
  t.example("beyond half of S_3 the formula of a smaller cap misses a rotated vector, which all rotations hold",
            {.form = "repaired", .hypothesis = "s^2 < 1/2"}, [] {
              using namespace rotation_cap;
              const Q s2 = squared_half_chord<Q>(wide, apex);
              const CapBallRatios<Q> ratios = cap_ball_ratios(rotated_cap_versine(s2));
              const Vec<Q, 3> image = rotate_by<Q>(combine<Q, 4>(weights, wide), x);
              const SquaredBall<Q, 3> ball{x * ratios.center, ratios.squared_radius};
              const RotationBound<Q> all = all_rotations<Q>();
              return s2 == Q(9, 10) && ratios.center == Q(7, 25) && ratios.squared_radius == Q(24 * 24, 25 * 25) &&
                     encloses(ball, image) == Verdict::fails && squared_norm(image) <= sq(all.radius_ratio);
            });
  t.holds("every non-zero element of the hull maps x into the ball that the lemmas give",
          {.form = "repaired", .number_type = "rational", .cases = 2000, .degenerate_at_least = 0.2}, [] {
            const Hull h = draw(5);
            const auto x = *gen::rational_vector<3>();
            const auto w = *gen::convex_weights(static_cast<int>(h.unit.size()));
            const RationalQuaternion q = combine<Rational, 4>(w, h.unit);
            RC_PRE(squared_norm(q) != 0);
            RC_CLASSIFY(is_degenerate(h), "degenerate");
            const auto ball = ball_from_lemmas(h, x);
            RC_CLASSIFY(ball.squared_radius < squared_norm(x), "a bound");
            const RationalVec<3> image = rotate_scaled(q, x) / squared_norm(q);
            RC_ASSERT(encloses(ball, image) == Verdict::holds);
          });
  t.holds("the bound by chords is the ball of the one cap lemma and Lemma 5",
          {.form = "repaired", .number_type = "exact roots", .cases = 400, .degenerate_at_least = 0.2}, [] {
            const Hull h = draw(4);
            const auto x = *gen::rational_vector<3>();
            RC_CLASSIFY(is_degenerate(h), "degenerate");
            RC_ASSERT(same(ball_from_bound<ExactRoot>(h, x), ball_from_lemmas(h, x)) == Verdict::holds);
          });
  t.holds("intervals hold the ball of the lemmas, or that of all rotations where they cannot tell",
          {.form = "repaired", .number_type = "interval", .cases = 2000, .degenerate_at_least = 0.2}, [] {
            const Hull h = draw(5);
            const auto x = *gen::rational_vector<3>();
            RC_CLASSIFY(is_degenerate(h), "degenerate");
            const auto ball = ball_from_bound<Interval>(h, x);
            const SquaredBall<Rational, 3> all{RationalVec<3>::Zero(), squared_norm(x)};
            RC_ASSERT(same(ball, ball_from_lemmas(h, x)) != Verdict::fails || same(ball, all) != Verdict::fails);
          });
  t.example("no direction, and quaternions on a half-sphere's rim or beyond, are all rotations", {.form = "repaired"}, [] {
    const std::vector<Quaternion<double>> opposite{{1, 0, 0, 0}, {-1, 0, 0, 0}}, rim{{1, 0, 0, 0}, {0, 1, 0, 0}};
    bool all = true;
    for (const auto& [unit, direction] :
         {std::pair{opposite, Quaternion<double>{0, 0, 0, 0}}, std::pair{opposite, Quaternion<double>{1, 0, 0, 0}},
          std::pair{rim, Quaternion<double>{1, 0, 0, 0}}, std::pair{rim, Quaternion<double>{-1, -1, 0, 0}},
          std::pair{rim, Quaternion<double>::Constant(std::nan("")).eval()}}) {
      const auto bound = bound_rotations<double>(unit, direction);
      all = all && bound.center_ratio == 0 && bound.radius_ratio == 1 && squared_norm(bound.apex) == 1;
    }
    return Checked(all, 5);
  });
}

Checked chords_keep_their_digits() {
  std::mt19937 random(2006);
  std::normal_distribution<double> gauss;
  double chord_worst = 0, dot_worst = 0;
  long too_small = 0, cases = 0;
  for (double half_angle = 0.3; half_angle > 1e-3; half_angle /= 1.1)
    for (int i = 0; i < 100; ++i, ++cases) {
      Quaternion<double> middle(gauss(random), gauss(random), gauss(random), gauss(random));
      Quaternion<double> side(gauss(random), gauss(random), gauss(random), gauss(random));
      middle /= norm(middle);
      side -= middle * dot(middle, side);
      side /= norm(side);
      const std::vector<Quaternion<float>> unit{(middle * std::cos(half_angle) + side * std::sin(half_angle)).cast<float>(),
                                                (middle * std::cos(half_angle) - side * std::sin(half_angle)).cast<float>()};
      const Quaternion<float> direction = (unit[0] + unit[1]) / 2;
      const double sine = std::sin(2 * half_angle);
      const double by_dot = sine_by_dot(unit, direction / norm(direction));
      chord_worst = std::max(chord_worst, std::abs(bound_rotations<float>(unit, direction).radius_ratio / sine - 1));
      dot_worst = std::max(dot_worst, std::abs(by_dot / sine - 1));
      too_small += by_dot < sine;
    }
  char text[160];
  std::snprintf(text, sizeof text,
                "half angles 0.3 to 0.001 rad, worst relative error of sin alpha: chord %.1e, dot %.1e; "
                "by dot too small in %.0f %%",
                chord_worst, dot_worst, 100.0 * too_small / cases);
  return Checked(chord_worst < 3e-4 && dot_worst > 100 * chord_worst, cases, text);
}

PROPTEST(rotation_bound) {
  bounds_hold_the_balls_of_the_lemmas(t);
  t.example("in float the chord keeps its digits at small angles, where the dot product loses them", {.number_type = "float"},
            chords_keep_their_digits);
}

}  // namespace
}  // namespace proptests::suite_rotation_bound
