// SPDX-License-Identifier: MIT
// Beyond the paper: one lemma in place of Lemmas 2 to 4, for quaternions of any length.
//
// Statement. Let q_1 ... q_m and c be vectors of R^4 and kappa^2 >= 0, with (q_k, c) >= 0 and
//   kappa^2 ||q_k||^2 ||c||^2 <= (q_k, c)^2 for all k.
// Every convex combination b of the q_k has (b, c) >= 0 and kappa^2 ||b||^2 ||c||^2 <= (b, c)^2. So if neither b nor c
// is 0, R_b v is within the angle with cosine 2 kappa^2 - 1 of R_c v. If all (q_k, c) > 0, then b is not 0. The best
// kappa^2 for non-zero q_k and c is min_k (q_k, c)^2 / (||q_k||^2 ||c||^2): rational for rational data.
//
// Replaces: Lemmas 2, 3, 4, Corollary 1, and the angle of Equation 6.
// Notation: q'_k -> quaternions[k], c -> axis, u -> coefficients, kappa^2 -> squared_cosine.
//
// Proof. With G_kl = (q_k, c)(q_l, c) - kappa^2 ||c||^2 (q_k, q_l),
//   (b, c)^2 - kappa^2 ||c||^2 ||b||^2 = sum_kl u_k u_l G_kl,
// and each G_kl >= 0, because (q_k, c) >= kappa ||c|| ||q_k||.
#pragma once

#include <span>
#include <vector>

#include "lemmas/s43_rotated_cap.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// Returns the greatest kappa^2 for non-zero quaternions and a non-zero axis.
template <class S>
S squared_cap_cosine(std::span<const Quaternion<S>> quaternions, const Quaternion<S>& axis) {
  const auto ratio = [&](const Quaternion<S>& q) { return S(sq(dot(q, axis)) / (squared_norm(q) * squared_norm(axis))); };
  S least = ratio(quaternions[0]);
  for (const auto& q : quaternions.subspan(1)) least = min_of(least, ratio(q));
  return least;
}

// --- Hypotheses ---

// No quaternion is behind the axis.
template <class S>
Verdict are_ahead(std::span<const Quaternion<S>> quaternions, const Quaternion<S>& axis) {
  Verdict v = Verdict::holds;
  for (const auto& q : quaternions) v &= less_equal(S(0), dot(q, axis));
  return v;
}

// kappa^2 bounds the angle of each quaternion.
template <class S>
Verdict are_within_cosine(std::span<const Quaternion<S>> quaternions, const Quaternion<S>& axis, const S& squared_cosine) {
  Verdict v = Verdict::holds;
  for (const auto& q : quaternions) v &= less_equal(S(squared_cosine * squared_norm(q) * squared_norm(axis)), sq(dot(q, axis)));
  return v;
}

template <class S>
Verdict one_cap_hypotheses(std::span<const Quaternion<S>> quaternions, const Quaternion<S>& axis, const S& squared_cosine,
                           std::span<const S> coefficients) {
  return are_ahead(quaternions, axis) & are_within_cosine(quaternions, axis, squared_cosine) & is_convex(coefficients);
}

// --- Conclusion ---

// The witness is the matrix G. If no entry is negative, the statement holds for all coefficients at once.
template <class S>
struct OneCap {
  Verdict verdict;
  std::vector<S> gram;  // G_kl in rows
};

template <class S>
Verdict is_one_cap(std::span<const Quaternion<S>> quaternions, const Quaternion<S>& axis, const S& squared_cosine,
                   const std::vector<S>& gram) {
  const std::size_t m = quaternions.size();
  if (gram.size() != m * m) return Verdict::fails;
  Verdict v = are_ahead(quaternions, axis);
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t l = 0; l < m; ++l) {
      const S left = dot(quaternions[k], axis) * dot(quaternions[l], axis);
      const S right = squared_cosine * squared_norm(axis) * dot(quaternions[k], quaternions[l]);
      v &= equal(gram[k * m + l], S(left - right)) & less_equal(S(0), gram[k * m + l]);
    }
  return v;
}

// The cap of angle arccos kappa about c holds the blend with the given coefficients.
template <class S>
OneCap<S> one_cap(std::span<const Quaternion<S>> quaternions, const Quaternion<S>& axis, const S& squared_cosine,
                  std::span<const S> coefficients) {
  std::vector<S> gram;
  Verdict strictly_ahead = Verdict::holds;
  for (const auto& a : quaternions) {
    strictly_ahead &= less(S(0), dot(a, axis));
    for (const auto& b : quaternions)
      gram.push_back(dot(a, axis) * dot(b, axis) - squared_cosine * squared_norm(axis) * dot(a, b));
  }
  const Quaternion<S> blend = combine(coefficients, quaternions);
  const S along = dot(blend, axis);
  const Verdict v = less_equal(S(0), along) &
                    less_equal(S(squared_cosine * squared_norm(axis) * squared_norm(blend)), sq(along)) &
                    implies(strictly_ahead, less(S(0), squared_norm(blend)));
  return {v, std::move(gram)};
}

// Judges the statement in R^3, for a blend and an axis that are not 0: R_b v is within the angle with cosine 2 kappa^2 - 1 of R_c
// v.
template <class S>
RotatedPair<S> one_cap_rotated(const Quaternion<S>& blend, const Quaternion<S>& axis, const S& squared_cosine,
                               const Vec<S, 3>& v) {
  return rotated_cap<S>(axis, blend, v, S(S(2) * squared_cosine - S(1)));
}

}  // namespace refitlab

// Sources: none; the copositive form of the proof.
// Used by: b4_cap_fallback; algorithms/certificate/bound.cpp, experiments/drawings/control_hulls.cpp,
// experiments/drawings/one_cap.cpp.
