// SPDX-License-Identifier: MIT
// Beyond the paper: the smallest ball of points on the unit sphere gives the smallest cap, and is a nearest-point
// problem.
//
// Statement. Let n_1 ... n_m be unit vectors of R^d with 0 outside their hull, and c the point of the hull nearest to
// 0. Then the smallest ball that encloses the n_k has center c and squared radius 1 - ||c||^2; the smallest cap of the
// sphere that holds them has apex c / ||c|| and cosine d_H = ||c|| = min_k (n_k, c) / ||c||.
//
// Replaces: BOUNDINGSPHERE on line 11 of Algorithm 1, where the smallest cap is wanted.
// Notation: q''_k -> units[k], c_E -> nearest point, u -> coefficients: c = sum_k u_k n_k.
//
// Proof. c is nearest if and only if (n_k, c) >= ||c||^2 for all k. Then ||n_k - c||^2 <= 1 - ||c||^2. For any other
// center g, sum_k u_k ||n_k - g||^2 = 1 - ||c||^2 + ||g - c||^2, and for any unit a, min_k (n_k, a) <= (c, a) <= ||c||.
#pragma once

#include <span>

#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/t3_min_dot_distance.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// --- Hypotheses ---

// c = sum_k u_k n_k is the point of the hull nearest to 0: no n_k is on the near side of the plane through c.
template <class S, int D>
Verdict is_nearest_point(std::span<const Vec<S, D>> points, std::span<const S> coefficients) {
  if (points.empty() || points.size() != coefficients.size()) return Verdict::fails;
  const Vec<S, D> c = combine(coefficients, points);
  Verdict v = is_convex(coefficients);
  for (const auto& p : points) v &= less_equal(squared_norm(c), dot(p, c));
  return v;
}

template <class S, int D>
Verdict smallest_cap_hypotheses(std::span<const Vec<S, D>> units, std::span<const S> coefficients) {
  const Verdict v = are_units(units) & is_nearest_point(units, coefficients);
  if (v == Verdict::fails) return v;  // there may be no combination: not one coefficient a unit
  return v & less(S(0), squared_norm(combine(coefficients, units)));
}

// --- Conclusion ---

// The witness is the ball with the combination that makes its center: a certificate of a smallest ball without roots.
template <class S, int D>
struct SmallestCap {
  Verdict verdict;
  Vec<S, D> center;    // c
  S squared_radius;    // 1 - ||c||^2
  S squared_distance;  // d_H^2 = ||c||^2
};

// It encloses; its support, the n_k with u_k > 0, is on its boundary; its center is a convex combination of the
// support.
template <class S, int D>
Verdict is_smallest_ball(std::span<const Vec<S, D>> points, std::span<const S> coefficients, const Vec<S, D>& center,
                         const S& squared_radius) {
  if (points.empty() || points.size() != coefficients.size()) return Verdict::fails;
  Verdict v = is_convex(coefficients);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const S distance2 = refitlab::squared_distance(points[k], center);
    v &= less_equal(distance2, squared_radius) & implies(less(S(0), coefficients[k]), equal(distance2, squared_radius));
  }
  const Vec<S, D> sum = combine(coefficients, points);
  for (int i = 0; i < D; ++i) v &= equal(sum[i], center[i]);
  return v;
}

// The cap that the nearest point makes holds all units, and the same certificate holds for the ball.
template <class S, int D>
SmallestCap<S, D> smallest_cap(std::span<const Vec<S, D>> units, std::span<const S> coefficients) {
  const Vec<S, D> c = combine(coefficients, units);
  const S c2 = squared_norm(c), r2 = S(1) - c2;
  Verdict v = less(S(0), c2) & is_smallest_ball(units, coefficients, c, r2);
  // d_H ||c|| by Equation 6 and d_H ||c|| as a minimum of dot products are both ||c||^2.
  v &= equal(S(scaled_distance(c, r2) / S(2)), c2) & equal(min_dot_distance(units, c, r2).least_dot, c2);
  return {v, c, r2, c2};
}

// No other center has a smaller enclosing ball: some unit is at least as far from it.
template <class S, int D>
Verdict is_not_smaller_ball(std::span<const Vec<S, D>> units, const SmallestCap<S, D>& cap, const Vec<S, D>& center) {
  S farthest = squared_distance(units[0], center);
  for (const auto& n : units.subspan(1)) farthest = max_of(farthest, squared_distance(n, center));
  return less_equal(cap.squared_radius, farthest);
}

// No other apex has a smaller cap: min_k (n_k, a) <= ||c|| ||a||. The apex has any positive length.
template <class S, int D>
Verdict is_not_smaller_cap(std::span<const Vec<S, D>> units, const SmallestCap<S, D>& cap, const Vec<S, D>& apex) {
  const S least = min_dot_distance(units, apex, S(0)).least_dot;
  return less_equal(least, S(0)) | less_equal(sq(least), S(cap.squared_distance * squared_norm(apex)));
}

}  // namespace refitlab

// Sources: CGAL Bounding_volumes (the certificate); Gilbert, Johnson and Keerthi 1988 (the nearest point).
// Used by: no program.
