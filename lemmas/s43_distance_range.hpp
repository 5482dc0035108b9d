// SPDX-License-Identifier: MIT
// Section 4.3, the range of the distance: d_H = (1 + ||c||^2 - r^2) / (2 ||c||) is in [0, 1], and arccos d_H exists.
//
// Statement. Let E = [c, r] be a ball of R^d with c != 0. If | ||c|| - 1 | <= r and r^2 <= 1 + ||c||^2, then d_H is in
// [0, 1]. The first holds as soon as E holds one unit vector; the second as soon as r <= 1.
//
// Paper: section 4.3, after Equation 6.
// Notation: c_E -> center, r_E -> radius, d_H -> scaled_distance / (2 ||center||).
//
// Proof. 0 <= d_H is the second condition. With N = 1 + ||c||^2 - r^2 = 2 ||c|| d_H,
//   4 ||c||^2 - N^2 = ((1 + r)^2 - ||c||^2) (||c||^2 - (1 - r)^2),
// Heron's formula for a triangle with the sides 1, r, ||c||; both factors are >= 0 when | ||c|| - 1 | <= r.
#pragma once

#include "lemmas/lemma3_sphere_surface_intersection.hpp"

namespace refitlab {

// d_H is defined and in [0, 1].
template <class S, int D>
Verdict distance_is_in_range(const Vec<S, D>& center, const S& squared_radius) {
  const S n = scaled_distance(center, squared_radius);
  return less(S(0), squared_norm(center)) & less_equal(S(0), n) & less_equal(sq(n), S(S(4) * squared_norm(center)));
}

// --- Hypotheses ---

// ||c|| + r >= 1. This is all that the paper draws from "E intersects S_3".
template <class S, int D>
Verdict reaches_surface_from_inside(const Vec<S, D>& center, const S& radius) {
  return less_equal(S(1), radius) | less_equal(sq(S(S(1) - radius)), squared_norm(center));
}

// ||c|| - r <= 1.
template <class S, int D>
Verdict reaches_surface_from_outside(const Vec<S, D>& center, const S& radius) {
  return less_equal(squared_norm(center), sq(S(S(1) + radius)));
}

// r^2 <= 1 + ||c||^2: E holds at most half of S_3.
template <class S, int D>
Verdict is_at_most_half(const Vec<S, D>& center, const S& squared_radius) {
  return less_equal(squared_radius, S(S(1) + squared_norm(center)));
}

template <class S, int D>
Verdict distance_range_hypotheses_printed(const Vec<S, D>& center, const S& radius) {
  return less_equal(S(0), radius) & less(radius, S(1)) & reaches_surface_from_inside(center, radius);
}

template <class S, int D>
Verdict distance_range_hypotheses_repaired(const Vec<S, D>& center, const S& radius) {
  return less(S(0), squared_norm(center)) & less_equal(S(0), radius) & reaches_surface_from_inside(center, radius) &
         reaches_surface_from_outside(center, radius) & is_at_most_half(center, sq(radius));
}

// E holds the unit vector x, as it does in Algorithm 1.
template <class S, int D>
Verdict distance_range_hypotheses_by_point(const Vec<S, D>& center, const S& squared_radius, const Vec<S, D>& x) {
  return less(S(0), squared_norm(center)) & equal(squared_norm(x), S(1)) &
         less_equal(squared_distance(x, center), squared_radius) & is_at_most_half(center, squared_radius);
}

// --- Conclusion ---

template <class S>
struct DistanceRange {
  Verdict verdict;
  S from_outside;  // (1 + r)^2 - ||c||^2 >= 0
  S from_inside;   // ||c||^2 - (1 - r)^2 >= 0; the product of both is 4 ||c||^2 - N^2
};

template <class S, int D>
Verdict is_distance_range(const Vec<S, D>& center, const S& radius, const DistanceRange<S>& witness) {
  const S n = scaled_distance(center, sq(radius));
  return less_equal(S(0), witness.from_outside) & less_equal(S(0), witness.from_inside) &
         equal(S(witness.from_outside * witness.from_inside), S(S(4) * squared_norm(center) - sq(n))) & less_equal(S(0), n) &
         less(S(0), squared_norm(center));
}

template <class S, int D>
DistanceRange<S> distance_range(const Vec<S, D>& center, const S& radius) {
  const S c2 = squared_norm(center);
  return {distance_is_in_range(center, sq(radius)), sq(S(S(1) + radius)) - c2, c2 - sq(S(S(1) - radius))};
}

// Judges a ball by its squared radius and one unit vector in it. The vector is the witness: N / 2 <= (x, c) <= ||c||.
template <class S, int D>
Verdict distance_range_by_point(const Vec<S, D>& center, const S& squared_radius, const Vec<S, D>& x) {
  const S n = scaled_distance(center, squared_radius), along = dot(x, center);
  return less_equal(n, S(S(2) * along)) & less_equal(sq(along), squared_norm(center)) &
         distance_is_in_range(center, squared_radius);
}

// --- Erratum ---
// From "E intersects S_3" the paper keeps only ||c|| + r >= 1 and squares r >= 1 - ||c|| although the right side is
// negative for ||c|| > 1. A ball outside S_3 that does not touch it passes.

// Printed: r < 1 and ||c|| + r >= 1 give a d_H in [0, 1].
template <class S, int D>
Verdict distance_range_printed(const Vec<S, D>& center, const S& radius) {
  return implies(distance_range_hypotheses_printed(center, radius), distance_range(center, radius).verdict);
}

template <class S, int D>
Verdict distance_range_repaired(const Vec<S, D>& center, const S& radius) {
  return implies(distance_range_hypotheses_repaired(center, radius), distance_range(center, radius).verdict);
}

}  // namespace refitlab

// Sources: the paper; Heron's formula.
// Used by: s43_whole_sphere_fallback; experiments/drawings/sections.cpp.
