// SPDX-License-Identifier: MIT
// Section 4.3, when to fall back on the whole of S_3.
//
// Statement. Let n_1 ... n_m be unit vectors in the ball E = [c, r] of R^4, and let N = 1 + ||c||^2 - r^2. If N > 0,
// then c is not 0, no convex combination b of the n_k is 0, and b / ||b|| is in the cap of S_3 with apex c / ||c|| and
// cosine d_H = N / (2 ||c||) > 0; so R_b v is within the angle with cosine 2 d_H^2 - 1 of R_c v. If N <= 0, the cosine
// -1 (all of the sphere) is a bound for the blends that are not 0.
//
// Paper: section 4.3, the paragraph before Equation 6; lines 12-15 of Algorithm 1.
// Notation: q''_k -> units[k], c_E -> center, r_E^2 -> squared_radius, N -> scaled_distance, u -> coefficients.
//
// Proof. ||n_k - c||^2 <= r^2 is (n_k, c) >= N / 2. So (b, c) >= N / 2 > 0, and N / 2 >= (N / 2) ||b||, as ||b|| <= 1.
#pragma once

#include <span>

#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/s43_distance_range.hpp"
#include "lemmas/s43_rotated_cap.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// --- Hypotheses ---

template <class S>
Verdict units_in_ball(std::span<const Quaternion<S>> units, const Quaternion<S>& center, const S& squared_radius) {
  Verdict v = Verdict::holds;
  for (const auto& n : units) v &= equal(squared_norm(n), S(1)) & less_equal(squared_distance(n, center), squared_radius);
  return v;
}

// The ball makes a cap of less than a half of S_3: r^2 < 1 + ||c||^2. A ball that holds a unit quaternion then has c != 0. With c
// = 0 there is no cap.
template <class S>
Verdict ball_makes_cap(const Quaternion<S>& center, const S& squared_radius) {
  return less(S(0), squared_norm(center)) & less(S(0), scaled_distance(center, squared_radius));
}

// --- Conclusion ---

// The cap on S_3 holds the blend: b != 0 and (b, c) >= (N / 2) ||b||.
template <class S>
struct BlendInCap {
  Verdict verdict;
  Quaternion<S> blend;
  S along;  // (b, c), at least N / 2
};

template <class S>
Verdict is_blend_in_cap(std::span<const Quaternion<S>> units, const Quaternion<S>& center, const S& squared_radius,
                        std::span<const S> coefficients, const BlendInCap<S>& witness) {
  const S half = scaled_distance(center, squared_radius) / S(2);
  Verdict v = less(S(0), half) & equal(dot(witness.blend, center), witness.along) & less_equal(half, witness.along) &
              less_equal(squared_norm(witness.blend), S(1));
  const Quaternion<S> sum = combine(coefficients, units);
  for (int i = 0; i < 4; ++i) v &= equal(sum[i], witness.blend[i]);
  return v;
}

template <class S>
BlendInCap<S> blend_in_cap(std::span<const Quaternion<S>> units, const Quaternion<S>& center, const S& squared_radius,
                           std::span<const S> coefficients) {
  const Quaternion<S> blend = combine(coefficients, units);
  const S along = dot(blend, center), n = scaled_distance(center, squared_radius);
  // Both sides are squared with their signs, as N may be negative where the statement is tried without its hypotheses.
  const S left = S(4) * sq(along), right = sq(n) * squared_norm(blend);
  const Verdict ahead = less_equal(S(0), along), positive = less_equal(S(0), n);
  const Verdict v = (positive & ahead & less_equal(right, left)) | (!positive & (ahead | less_equal(left, right)));
  return {v & less(S(0), squared_norm(blend)), blend, along};
}

// --- Erratum: r_E >= 1 is the wrong border, and Algorithm 1 does not look at it ---

// Printed: the whole of S_3 is needed as soon as r_E >= 1.
template <class S>
Verdict fallback_is_needed_printed(const S& squared_radius) {
  return less_equal(S(1), squared_radius);
}

// Repaired: it is needed if and only if the ball makes no cap of less than a half.
template <class S>
Verdict fallback_is_needed_repaired(const Quaternion<S>& center, const S& squared_radius) {
  return !ball_makes_cap(center, squared_radius);
}

// Line 15 as printed, with no fallback: c_E != 0, |d_H| <= 1, and the radius sin(2 arccos d_H) ||u||, which has the
// sign of d_H, is not negative.
template <class S>
Verdict line_15_makes_ball_printed(const Quaternion<S>& center, const S& squared_radius) {
  return distance_is_in_range(center, squared_radius);
}

// This cap in R^3 holds all the R_b v.
template <class S>
struct RotatedVectorsCap {
  Quaternion<S> apex;  // non-zero, of any length; the cap's apex is R_apex v
  S cos_angle;         // cos alpha = 2 d_H^2 - 1; -1 for the whole sphere
};

// Computes the repaired line 13, which falls back to the whole sphere whenever the cap is not certain.
template <class S>
RotatedVectorsCap<S> rotated_vectors_cap_repaired(const Quaternion<S>& center, const S& squared_radius) {
  if (ball_makes_cap(center, squared_radius) != Verdict::holds) return {identity_quaternion<S>(), S(-1)};
  return {center, sq(scaled_distance(center, squared_radius)) / (S(2) * squared_norm(center)) - S(1)};
}

// Judges the repaired lines 13-15 for a blend that is not 0: cos alpha is in [-1, 1], so that sin alpha exists, and R_b v is in
// the cap.
template <class S>
Verdict rotated_blend_is_bounded(const RotatedVectorsCap<S>& cap, const Quaternion<S>& blend, const Vec<S, 3>& v) {
  return less_equal(S(-1), cap.cos_angle) & less_equal(cap.cos_angle, S(1)) &
         rotated_cap(cap.apex, blend, v, cap.cos_angle).verdict;
}

}  // namespace refitlab

// Sources: the paper, with Lemmas 3 and 4.
// Used by: experiments/explorer/pages/whole_sphere.hpp.
