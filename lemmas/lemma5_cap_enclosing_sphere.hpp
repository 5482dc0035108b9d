// SPDX-License-Identifier: MIT
// Lemma 5: the smallest ball that encloses a cap.
//
// Statement. Let C = {x : ||x - c|| = r, (x - c, a - c) >= r^2 cos alpha}, r = ||a - c||, be a cap of R^d, d >= 2, of angle
// alpha in [0, pi]. Let k = max(cos alpha, 0). The ball with center c + k (a - c) and radius sqrt(1 - k^2) r encloses C. No
// other ball that small encloses C, because two points of C are the ends of a diameter of this ball. For alpha beyond pi/2
// the ball has the whole sphere's center and radius. In R^1 the ball encloses C too, but it is the smallest only for k = 1
// or alpha = pi.
//
// Paper: appendix, Lemma 5, where c = 0; used in section 4.3 and line 15 of Algorithm 1.
// Notation: a -> cap.apex, cos alpha -> cap.cos_angle, r^2 -> squared_radius(cap), v -> rim_direction,
// v_1 and v_2 -> first and second.
//
// Proof. For x in C: ||x - c - k (a - c)||^2 = r^2 - 2k (x - c, a - c) + k^2 r^2 <= r^2 (1 - 2k cos + k^2) <= r^2 (1 -
// k^2), since k >= 0 and k cos = k^2. A ball that holds both ends of a diameter of another ball is no smaller. If it is no
// larger, it is the same ball.
#pragma once

#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace refitlab {

// --- Hypotheses ---

// cos alpha <= 1: the cap holds its apex. (An angle also has cos alpha >= -1, but the repaired statement does not need
// this.)
template <class S, int D>
Verdict cap_has_points(const Cap<S, D>& cap) {
  return less_equal(cap.cos_angle, S(1));
}

// v and the sine give a point of the rim: v is perpendicular to a - c and has its length, sine >= 0, and cos^2 + sine^2 = 1.
template <class S, int D>
Verdict is_rim(const Cap<S, D>& cap, const S& sine, const Vec<S, D>& rim_direction) {
  const Vec<S, D> axis = cap.apex - cap.center;
  return equal(dot(axis, rim_direction), S(0)) & equal(squared_norm(rim_direction), squared_norm(axis)) & less_equal(S(0), sine) &
         equal(S(sq(cap.cos_angle) + sq(sine)), S(1));
}

// --- Conclusion ---

// The ratios are the ball's center as a share of a - c, which is k = max(cos alpha, 0), and its squared radius as a share of r^2,
// which is 1 - k^2.
template <class S>
struct CapBallRatios {
  S center, squared_radius;
};

// Computes the ratios from the versine 1 - cos alpha, which keeps its digits at small angles.
template <class S>
CapBallRatios<S> cap_ball_ratios(const S& versine) {
  const S v = min_of(versine, S(1));
  return {S(1) - v, v * (S(2) - v)};
}

template <class S, int D>
CapBallRatios<S> cap_ball_ratios(const Cap<S, D>& cap) {
  return cap_ball_ratios<S>(S(1) - cap.cos_angle);
}

template <class S, int D>
SquaredBall<S, D> cap_ball_repaired(const Cap<S, D>& cap) {
  const CapBallRatios<S> ratios = cap_ball_ratios(cap);
  return {cap.center + (cap.apex - cap.center) * ratios.center, ratios.squared_radius * squared_radius(cap)};
}

// The first half of the conclusion: the ball encloses the cap.
template <class S, int D>
Verdict cap_ball_encloses_repaired(const Cap<S, D>& cap, const Vec<S, D>& x) {
  return implies(cap_has_points(cap) & contains(cap, x), encloses(cap_ball_repaired(cap), x));
}

// The second half: no smaller ball does. The witness is a diameter of the ball with both ends in the cap.
template <class S, int D>
struct CapBall {
  Verdict verdict;
  SquaredBall<S, D> ball;
  S height;                 // k
  Vec<S, D> first, second;  // the ends of the diameter
};

// Computes the ball from the sine of the angle and a direction to the rim, without a root.
template <class S, int D>
CapBall<S, D> smallest_cap_ball(const Cap<S, D>& cap, const S& sine, const Vec<S, D>& rim_direction) {
  const SquaredBall<S, D> ball = cap_ball_repaired(cap);
  const Verdict wide = less_equal(cap.cos_angle, S(0));
  const Vec<S, D> half = rim_direction * (wide == Verdict::holds ? S(1) : sine);
  return {cap_has_points(cap) & less_equal(S(0), ball.squared_radius) & (wide | !wide), ball, cap_ball_ratios(cap).center,
          ball.center + half, ball.center - half};
}

// Computes the same from the cap alone. It takes two roots. d >= 2, r > 0.
template <class S, int D>
CapBall<S, D> smallest_cap_ball_by_roots(const Cap<S, D>& cap) {
  static_assert(D >= 2);
  const Vec<S, D> axis = cap.apex - cap.center;
  int longest = 0;  // a coordinate of the axis that is not 0, to turn the axis by a right angle in a coordinate plane
  for (int i = 1; i < D; ++i)
    if (prefer_less(sq(axis[longest]), sq(axis[i]))) longest = i;
  const int other = longest == 0 ? 1 : 0;
  Vec<S, D> v = Vec<S, D>::Constant(S(0));
  v[longest] = -axis[other];
  v[other] = axis[longest];
  const S stretch = root(S(squared_norm(axis) / squared_norm(v)));
  return smallest_cap_ball<S, D>(cap, root(S(S(1) - sq(cap.cos_angle))), v * stretch);
}

// Checks the witness independently. For "encloses", the center is height >= 0 along the axis, and the squared distance of
// the cap's farthest point from it is at most r^2 (1 - 2 height cos + height^2). For "smallest", the ends are in the cap,
// on the surface, and opposite. (Two ends so far apart lie on the rim or across the whole sphere, which determines the
// height and the center. Both halves are checked all the same, so that each can be seen by itself; a mutant without one of
// them is equivalent.)
template <class S, int D>
Verdict is_smallest_cap_ball(const Cap<S, D>& cap, const CapBall<S, D>& witness) {
  const Vec<S, D> axis = cap.apex - cap.center, along = witness.ball.center - cap.center;
  const Vec<S, D> sum = witness.first + witness.second;
  Verdict v = less_equal(S(0), witness.height) & contains(cap, witness.first) & contains(cap, witness.second) &
              on_surface(witness.ball, witness.first) &
              less_equal(S(squared_radius(cap) * (S(1) - S(2) * witness.height * cap.cos_angle + sq(witness.height))),
                         witness.ball.squared_radius);
  for (int i = 0; i < D; ++i) v &= equal(along[i], S(axis[i] * witness.height)) & equal(sum[i], S(witness.ball.center[i] * S(2)));
  return v;
}

// The witness proves this of any other ball: if the ball holds both ends, it is larger, or it is the same ball.
template <class S, int D>
Verdict no_other_ball_that_small(const CapBall<S, D>& witness, const SquaredBall<S, D>& other) {
  const Verdict holds_both = encloses(other, witness.first) & encloses(other, witness.second);
  const Verdict larger = less(witness.ball.squared_radius, other.squared_radius);
  const Verdict same =
      equal(witness.ball.squared_radius, other.squared_radius) & equal(squared_distance(witness.ball.center, other.center), S(0));
  return implies(holds_both, larger | same);
}

// --- Erratum: beyond pi/2 the printed ball misses the apex ---
// The proof multiplies -2 (x, a) <= -2 r^2 cos alpha by cos alpha, which keeps the order only for cos alpha >= 0. At alpha
// = pi the printed ball is the point -a, but the cap is the whole surface. In R^1 no v is perpendicular to a, and
// "smallest" fails: the cap {1} of angle pi/2 has the printed ball [-1, 1].

// Printed: For all angles of [0, pi], the ball has center a cos alpha and radius ||a|| sin alpha. The center of the cap is
// 0. Line 15 of Algorithm 1 makes the ball from cos alpha, sin alpha and the apex's length.
template <class S, int D>
Ball<S, D> cap_ball_printed(const Vec<S, D>& apex, const S& length, const S& cos_angle, const S& sin_angle) {
  return {apex * cos_angle, sin_angle * length};
}

// Computes the same in squares, without the root of a sine.
template <class S, int D>
SquaredBall<S, D> cap_ball_printed(const Cap<S, D>& cap) {
  return {cap.apex * cap.cos_angle, squared_norm(cap.apex) * (S(1) - sq(cap.cos_angle))};
}

template <class S, int D>
Verdict cap_ball_hypotheses_printed(const Cap<S, D>& cap) {
  return equal(squared_norm(cap.center), S(0)) & less_equal(S(-1), cap.cos_angle) & less_equal(cap.cos_angle, S(1));
}

template <class S, int D>
Verdict cap_ball_encloses_printed(const Cap<S, D>& cap, const Vec<S, D>& x) {
  return implies(cap_ball_hypotheses_printed(cap) & contains(cap, x), encloses(cap_ball_printed(cap), x));
}

}  // namespace refitlab

// Sources: the paper; a ball is the smallest around the two ends of its diameter (folklore).
// Used by: b4_cap_fallback, rotation_bound; algorithms/methods/refit/algorithm1_printed.hpp,
// experiments/drawings/lemmas.cpp, experiments/explorer/pages/lemma5.hpp, experiments/explorer/pages/whole_sphere.hpp,
// experiments/pictures/cap_figure.cpp.
