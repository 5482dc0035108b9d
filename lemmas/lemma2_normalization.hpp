// SPDX-License-Identifier: MIT
// Lemma 2: normalising the generators keeps the directions, and so the rotations, of a convex hull.
//
// Statement. Let q_1 ... q_m be vectors of R^d, let f_1 ... f_m > 0, and let p_i = q_i / f_i. For every w in W_m there are
// u in W_m and k > 0 with k sum u_i p_i = sum w_i q_i. So the hulls of the q_i and of the p_i span the same rays from 0,
// and one hull holds 0 if and only if the other does. The same is true in the other direction. If f_i = ||q_i|| > 0, the
// p_i are unit vectors. In R^4, each non-zero element of either hull is then the same rotation as an element of the other.
// 0 is no rotation.
//
// Paper: appendix, Lemma 2; used in section 4.3 and line 9 of Algorithm 1.
// Notation: q_i -> vectors[i], ||q_i|| -> factors[i], n_i -> divided(vectors, factors)[i], w and t -> weights,
// u and s -> witness.weights, K and L -> witness.scale.
//
// Proof. Let k = sum w_j f_j > 0 and u_i = w_i f_i / k. Then k sum u_i p_i = sum w_i f_i q_i / f_i. The other direction
// uses 1 / f_i.
#pragma once

#include <vector>

#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

template <class S, int D>
using VecList = std::vector<Vec<S, D>>;

// --- Hypotheses ---

template <class S>
Verdict are_positive(const std::vector<S>& factors) {
  Verdict v = Verdict::holds;
  for (const S& f : factors) v &= less(S(0), f);
  return v;
}

// factors[i] = ||vectors[i]||, and no factor is 0.
template <class S, int D>
Verdict are_lengths(const VecList<S, D>& vectors, const std::vector<S>& factors) {
  Verdict v = are_positive(factors);
  for (std::size_t i = 0; i < vectors.size(); ++i) v &= equal(sq(factors[i]), squared_norm(vectors[i]));
  return v;
}

// --- Conclusion ---

template <class S, int D>
VecList<S, D> divided(const VecList<S, D>& vectors, const std::vector<S>& factors) {
  VecList<S, D> out = vectors;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = vectors[i] / factors[i];
  return out;
}

template <class S>
std::vector<S> inverses(const std::vector<S>& factors) {
  std::vector<S> out;
  for (const S& f : factors) out.push_back(S(1) / f);
  return out;
}

// Computes the lengths. It takes a root for each.
template <class S, int D>
std::vector<S> lengths_by_roots(const VecList<S, D>& vectors) {
  std::vector<S> out;
  for (const auto& q : vectors) out.push_back(norm(q));
  return out;
}

// The witness is the element of the other hull on the same ray.
template <class S>
struct SameRay {
  Verdict verdict;         // scale > 0 and the weights are not negative
  std::vector<S> weights;  // u
  S scale;                 // k
};

// Goes from the hull of the q_i to that of the q_i / f_i. The other direction is the same with the inverse factors. sum w_i
// f_i != 0.
template <class S>
SameRay<S> weights_on_same_ray(const std::vector<S>& weights, const std::vector<S>& factors) {
  S scale(0);
  for (std::size_t i = 0; i < weights.size(); ++i) scale = scale + weights[i] * factors[i];
  SameRay<S> out{less(S(0), scale), {}, scale};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    out.weights.push_back(weights[i] * factors[i] / scale);
    out.verdict &= less_equal(S(0), out.weights.back());
  }
  return out;
}

// Checks the witness independently: scale sum u_i to_i = sum w_i from_i, with u in W_m and scale > 0.
template <class S, int D>
Verdict is_same_ray(const VecList<S, D>& from, const std::vector<S>& weights, const VecList<S, D>& to,
                    const SameRay<S>& witness) {
  if (witness.weights.size() != to.size()) return Verdict::fails;
  const Vec<S, D> a = combine<S, D>(weights, from), b = combine<S, D>(witness.weights, to);
  Verdict v = less(S(0), witness.scale) & is_convex<S>(witness.weights);
  for (int i = 0; i < D; ++i) v &= equal(S(b[i] * witness.scale), a[i]);
  return v;
}

// Judges both directions: from w in the hull of the q_i, and from w in the hull of the p_i.
template <class S, int D>
Verdict normalisation_keeps_rays_repaired(const VecList<S, D>& vectors, const std::vector<S>& factors,
                                          const std::vector<S>& weights) {
  const Verdict hypotheses = are_positive(factors) & is_convex<S>(weights);
  if (hypotheses == Verdict::fails) return Verdict::holds;  // a factor may be 0
  const VecList<S, D> divided_vectors = divided<S, D>(vectors, factors);
  const Verdict there = is_same_ray(vectors, weights, divided_vectors, weights_on_same_ray(weights, factors));
  const Verdict back = is_same_ray(divided_vectors, weights, vectors, weights_on_same_ray(weights, inverses(factors)));
  return implies(hypotheses, there & back);
}

// p and q are one rotation: neither is 0, and all of their 2 x 2 minors vanish.
template <class S, int D>
Verdict are_same_rotation(const Vec<S, D>& p, const Vec<S, D>& q) {
  Verdict v = less(S(0), squared_norm(p)) & less(S(0), squared_norm(q));
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < i; ++j) v &= equal(S(p[i] * q[j]), S(p[j] * q[i]));
  return v;
}

// The blends with weights w and u are both 0, or both are not 0.
template <class S, int D>
Verdict blends_vanish_together(const VecList<S, D>& vectors, const std::vector<S>& factors, const std::vector<S>& weights) {
  const Vec<S, D> a = combine<S, D>(weights, vectors);
  const auto witness = weights_on_same_ray(weights, factors);
  const Vec<S, D> b = combine<S, D>(witness.weights, divided<S, D>(vectors, factors));
  const Verdict first = less(S(0), squared_norm(a)), second = less(S(0), squared_norm(b));
  return implies(first, second) & implies(second, first);
}

// --- Erratum: 0 may be in the hull, and is no rotation ---
// "Choose an arbitrary a in M" may choose 0. (The proof also prints s_i = t_i q_i / (||q_i|| L), which is a vector, where
// t_i / (||q_i|| L) is meant.)

// Printed: For non-zero vectors, every element of their hull is a rotation, and the normalised hull has this rotation too.
template <class S, int D>
Verdict normalisation_keeps_rotations_printed(const VecList<S, D>& vectors, const std::vector<S>& lengths,
                                              const std::vector<S>& weights) {
  const Verdict hypotheses = are_lengths(vectors, lengths) & is_convex<S>(weights);
  if (hypotheses == Verdict::fails) return Verdict::holds;  // a length may be 0
  const Vec<S, D> a = combine<S, D>(weights, vectors);
  const auto witness = weights_on_same_ray(weights, lengths);
  const Vec<S, D> b = combine<S, D>(witness.weights, divided<S, D>(vectors, lengths));
  return implies(hypotheses, are_same_rotation(a, b));
}

// Repaired: The printed claim holds for every element that is not 0.
template <class S, int D>
Verdict normalisation_keeps_rotations_repaired(const VecList<S, D>& vectors, const std::vector<S>& lengths,
                                               const std::vector<S>& weights) {
  const Vec<S, D> a = combine<S, D>(weights, vectors);
  return implies(less(S(0), squared_norm(a)), normalisation_keeps_rotations_printed(vectors, lengths, weights));
}

}  // namespace refitlab

// Sources: the paper. Generators of a convex cone may be scaled by positive factors (folklore).
// Used by: lemma4_quaternion_hull; experiments/drawings/lemmas.cpp, experiments/explorer/pages/lemma2.hpp,
// experiments/explorer/pages/lemma4.hpp.
