// SPDX-License-Identifier: MIT
// Lemma 3: where a ball cuts a sphere's surface there is a cap, and its half-space is at a known distance.
//
// Statement. In R^d, d >= 1, let A be the surface with center a and radius r_a >= 0, and let B be the ball with center b !=
// a and radius r_b. Let delta = ||b - a||, e = delta^2 + r_a^2 - r_b^2 and H = {x : (x, 2 (b - a)) >= r_a^2 - r_b^2 +
// ||b||^2 - ||a||^2}.
// (1) A point of A is in B if and only if it is in H. A meets B if and only if A meets H, that is, if |delta - r_a| <= r_b.
// If they meet, their intersection is a cap (Lemma 1).
// (2) a is outside H if and only if r_b^2 < r_a^2 + delta^2. If e >= 0, the distance from a to H is e / (2 delta).
// For b = a there is no H, and B holds either all of A or nothing of it.
//
// Paper: appendix, Lemma 3; used in section 4.3 and line 13 of Algorithm 1, with a = 0 and r_a = 1.
// Notation: S_a -> surface, S_b -> ball, H -> half_space, distance of 0 and H (d_H) -> squared_distance of a FootPoint.
//
// Proof. For every x, ||x - b||^2 - r_b^2 is ||x - a||^2 - r_a^2 minus ((x, 2 (b - a)) - offset). On A the first of these
// two terms vanishes. Relative to a, the offset is e. The distance from a to its foot in the plane is e over the length of
// the normal.
#pragma once

#include "lemmas/lemma1_cap_definitions.hpp"

namespace refitlab {

// Returns e = ||b - a||^2 + r_a^2 - r_b^2, the offset of H as seen from a. It is 2 ||b - a|| times the signed distance.
template <class S, int D>
S intersection_offset(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball) {
  return squared_distance(surface.center, ball.center) + surface.squared_radius - ball.squared_radius;
}

// Returns e for the unit sphere about 0, 1 + ||c||^2 - r^2 = 2 ||c|| d_H. Line 13 of Algorithm 1 divides it by 2 ||c||.
template <class S, int D>
S scaled_distance(const Vec<S, D>& center, const S& squared_radius) {
  return S(1) + squared_norm(center) - squared_radius;
}

// --- Hypotheses ---

// b != a.
template <class S, int D>
Verdict are_eccentric(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball) {
  return less(S(0), squared_distance(surface.center, ball.center));
}

// Some point of the surface is in the ball. The nearest one is at the distance | ||b - a|| - r_a | from b.
template <class S, int D>
Verdict surface_meets_ball(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball) {
  const S across = S(4) * surface.squared_radius * squared_distance(surface.center, ball.center);
  return less_equal(S(0), surface.squared_radius) & at_most_root(intersection_offset(surface, ball), across);
}

// --- Conclusion (1): the intersection is a cap ---

template <class S, int D>
struct IntersectionCap {
  Verdict verdict;  // H is a half-space and meets the surface
  HalfSpace<S, D> half_space;
};

template <class S, int D>
IntersectionCap<S, D> intersection_cap(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball) {
  const Vec<S, D> normal = (ball.center - surface.center) * S(2);
  const HalfSpace<S, D> h{
      normal, surface.squared_radius - ball.squared_radius + squared_norm(ball.center) - squared_norm(surface.center)};
  return {is_half_space(h) & meets(surface, h), h};
}

// Checks the witness independently, for all x at once. Both sides of the proof's identity are affine in x, so it holds if
// it holds at the origin and at the ends of the coordinate vectors.
template <class S, int D>
Verdict is_intersection_cap(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball,
                            const IntersectionCap<S, D>& witness) {
  const HalfSpace<S, D>& h = witness.half_space;
  Verdict v = is_half_space(h);
  for (int i = -1; i < D; ++i) {
    Vec<S, D> x = Vec<S, D>::Constant(S(0));
    if (i >= 0) x[i] = S(1);
    const S of_surface = squared_distance(x, surface.center) - surface.squared_radius;
    const S of_ball = squared_distance(x, ball.center) - ball.squared_radius;
    v &= equal(S(of_surface - of_ball), S(dot(x, h.normal) - h.offset));
  }
  return v;
}

// A point of the surface is in the ball if and only if it is in the half-space.
template <class S, int D>
Verdict ball_and_half_space_agree(const SquaredBall<S, D>& ball, const HalfSpace<S, D>& h, const Vec<S, D>& x) {
  const Verdict first = encloses(ball, x), second = contains(h, x);
  return implies(first, second) & implies(second, first);
}

template <class S, int D>
Verdict intersection_is_cap_repaired(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball, const Vec<S, D>& x) {
  const auto made = intersection_cap(surface, ball);
  return implies(are_eccentric(surface, ball) & surface_meets_ball(surface, ball) & on_surface(surface, x),
                 made.verdict & ball_and_half_space_agree(ball, made.half_space, x));
}

// --- Conclusion (2): the distance ---

template <class S, int D>
struct FootPoint {
  Verdict verdict;     // a is not inside H
  Vec<S, D> foot;      // the point of H nearest to a
  S squared_distance;  // e^2 / (4 ||b - a||^2)
};

// b != a.
template <class S, int D>
FootPoint<S, D> nearest_point_of_intersection_cap(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball) {
  const Vec<S, D> axis = ball.center - surface.center;
  const S e = intersection_offset(surface, ball), square = squared_norm(axis);
  return {less_equal(S(0), e), surface.center + axis * S(e / (S(2) * square)), sq(e) / (S(4) * square)};
}

// Checks the witness independently: the foot is on the plane, and h lies beyond it as seen from the point, along the
// normal.
template <class S, int D>
Verdict is_nearest_point(const HalfSpace<S, D>& h, const Vec<S, D>& from, const FootPoint<S, D>& witness) {
  const Vec<S, D> way = witness.foot - from;
  Verdict v = is_half_space(h) & equal(dot(witness.foot, h.normal), h.offset) & less_equal(S(0), dot(way, h.normal)) &
              equal(squared_norm(way), witness.squared_distance);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < i; ++j) v &= equal(S(way[i] * h.normal[j]), S(way[j] * h.normal[i]));
  return v;
}

template <class S, int D>
Verdict center_is_outside_half_space(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball) {
  return less(ball.squared_radius, S(surface.squared_radius + squared_distance(surface.center, ball.center)));
}

// Judges both halves of (2).
template <class S, int D>
Verdict intersection_distance_repaired(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball) {
  const HalfSpace<S, D> h = intersection_cap(surface, ball).half_space;
  const Verdict outside = !contains(h, surface.center), small = center_is_outside_half_space(surface, ball);
  const Verdict agree = implies(outside, small) & implies(small, outside);
  const Verdict has_distance = are_eccentric(surface, ball) & less_equal(S(0), intersection_offset(surface, ball));
  if (has_distance == Verdict::fails) return agree;  // there may be no plane
  const auto nearest = nearest_point_of_intersection_cap(surface, ball);
  return agree & implies(has_distance, is_nearest_point(h, surface.center, nearest));
}

// --- Erratum ---
// The intersection may be empty, but an empty set is no cap. This happens if the ball is inside or beyond the surface. For
// b = a the normal is 0, and for b = 0 the distance divides by 0. On the other hand, r_b < 1 is more than the distance
// needs.

// Printed: Any surface and any ball meet in a cap.
template <class S, int D>
Verdict intersection_is_cap_printed(const SquaredBall<S, D>& surface, const SquaredBall<S, D>& ball, const Vec<S, D>& x) {
  const auto made = intersection_cap(surface, ball);
  const Verdict has_radii = less_equal(S(0), surface.squared_radius) & less_equal(S(0), ball.squared_radius);
  return implies(has_radii & on_surface(surface, x), made.verdict & ball_and_half_space_agree(ball, made.half_space, x));
}

// Printed: For a = 0, r_a = 1 and r_b < 1, the point 0 lies outside H, and the distance is (1 + ||b||^2 - r_b^2) / (2
// ||b||).
template <class S, int D>
Verdict intersection_distance_printed(const SquaredBall<S, D>& ball) {
  const SquaredBall<S, D> unit{Vec<S, D>::Constant(S(0)), S(1)};
  const HalfSpace<S, D> h = intersection_cap(unit, ball).half_space;
  const S b2 = squared_norm(ball.center), numerator = S(1) + b2 - ball.squared_radius;
  const Verdict defined = less(S(0), b2);
  // H is at the distance offset / ||normal|| from 0. Here both sides are squared and multiplied out.
  const Verdict right = equal(S(sq(numerator) * squared_norm(h.normal)), S(sq(h.offset) * S(4) * b2));
  return implies(less_equal(S(0), ball.squared_radius) & less(ball.squared_radius, S(1)),
                 defined & right & !contains(h, unit.center));
}

}  // namespace refitlab

// Sources: the paper; the plane is the radical plane of the two spheres.
// Used by: lemma4_quaternion_hull, s43_distance_range, s43_whole_sphere_fallback, t3_min_dot_distance,
// t3_smallest_ball_smallest_cap; algorithms/methods/refit/algorithm1_printed.hpp, experiments/drawings/common.hpp,
// experiments/drawings/lemmas.cpp, experiments/explorer/pages/lemma3.hpp, experiments/explorer/pages/lemma4.hpp,
// experiments/explorer/pages/whole_sphere.hpp, experiments/pictures/cap_figure.cpp.
