// SPDX-License-Identifier: MIT
// Beyond the paper: the distance d_H is a minimum of dot products, and the ball in R^4 is not needed.
//
// Statement. Let n_1 ... n_m be unit vectors of R^d, c != 0 and r the largest distance of an n_k from c. Then
//   d_H = (1 + ||c||^2 - r^2) / (2 ||c||) = min_k (n_k, c) / ||c||.
// For any larger r the left side is smaller: the direct form is never looser.
//
// Replaces: Equation 6 and the enclosing ball E of section 4.3.
// Notation: q''_k -> units[k], c_E -> center, r_E^2 -> squared_radius.
//
// Proof. ||n_k - c||^2 = 1 + ||c||^2 - 2 (n_k, c) is largest where (n_k, c) is least.
#pragma once

#include <span>

#include "lemmas/lemma3_sphere_surface_intersection.hpp"

namespace refitlab {

// --- Hypotheses ---

template <class S, int D>
Verdict are_units(std::span<const Vec<S, D>> vectors) {
  Verdict v = Verdict::holds;
  for (const auto& n : vectors) v &= equal(squared_norm(n), S(1));
  return v;
}

// r is the largest distance from the center.
template <class S, int D>
Verdict is_largest_distance(std::span<const Vec<S, D>> points, const Vec<S, D>& center, const S& squared_radius) {
  Verdict encloses = Verdict::holds, reached = Verdict::fails;
  for (const auto& p : points) {
    encloses &= less_equal(squared_distance(p, center), squared_radius);
    reached |= equal(squared_distance(p, center), squared_radius);
  }
  return encloses & reached;
}

template <class S, int D>
Verdict min_dot_distance_hypotheses(std::span<const Vec<S, D>> units, const Vec<S, D>& center, const S& squared_radius) {
  return are_units(units) & less(S(0), squared_norm(center)) & is_largest_distance(units, center, squared_radius);
}

// --- Conclusion ---

template <class S>
struct MinDotDistance {
  Verdict verdict;      // d_H exists and both forms of ||c|| d_H are equal
  Verdict not_looser;   // the direct form is at least the paper's
  std::size_t nearest;  // the k that attains the minimum
  S least_dot;          // ||c|| d_H by the direct form
};

// The k-th dot product is the given one, and no other is less.
template <class S, int D>
Verdict is_least_dot(std::span<const Vec<S, D>> units, const Vec<S, D>& center, const MinDotDistance<S>& witness) {
  if (witness.nearest >= units.size()) return Verdict::fails;
  Verdict v = equal(dot(units[witness.nearest], center), witness.least_dot);
  for (const auto& n : units) v &= less_equal(witness.least_dot, dot(n, center));
  return v;
}

template <class S, int D>
MinDotDistance<S> min_dot_distance(std::span<const Vec<S, D>> units, const Vec<S, D>& center, const S& squared_radius) {
  std::size_t nearest = 0;
  S least = dot(units[0], center);
  for (std::size_t k = 1; k < units.size(); ++k) {
    const S along = dot(units[k], center);
    if (prefer_less(along, least)) nearest = k;
    least = min_of(least, along);
  }
  const S paper = scaled_distance(center, squared_radius) / S(2);
  return {less(S(0), squared_norm(center)) & equal(paper, least), less_equal(paper, least), nearest, least};
}

}  // namespace refitlab

// Sources: none; the identity of the proof.
// Used by: t3_smallest_ball_smallest_cap; experiments/drawings/one_cap.cpp.
