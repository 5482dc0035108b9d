// SPDX-License-Identifier: MIT
// Beyond the paper: vertices that are displaced before they are skinned, by morph targets or reduced coordinates.
//
// Statement. Let v = v_0 + sum m_k d_k, with v_0 in the ball about c of radius r and the displacement d_k in that about c_k of
// radius r_k.
// (i) For given m, v is in the ball about c + sum m_k c_k of the radius r + sum |m_k| r_k. If displacements are independent, no
//   smaller one will do.
// (ii) For m_k in [l_k, h_k], with the middle n_k and half width e_k, and g_k = max(|l_k|, |h_k|), v is in the ball about
//   c + sum n_k c_k of the radius r + sum (e_k ||c_k|| + g_k r_k).
// (iii) In a direction, slabs of v_0 and of the d_k give that of v by products of intervals, summed. Boxes are three slabs.
// (iv) If the m_k move within M_k (lemmas/vocabulary/motion.hpp), v moves within the sum of M_k times ||d_k||, besides its own
//   size.
// Everything behind it (control hulls, trees, clusters, chains of joints) takes the displaced ball for the reference ball.
//
// Replaces: section 3, where the reference pose is one.
// Notation: m -> weights, c_k and r_k -> displacements.
//
// Proof. d_k = c_k + y_k with ||y_k|| <= r_k, and m_k d_k = n_k c_k + (m_k - n_k) c_k + m_k y_k. The extremes of a product of two
// numbers in intervals are at their ends. (iv) is Leibniz' rule with d_k at rest.
#pragma once

#include "lemmas/a1_affine_image.hpp"
#include "lemmas/vocabulary/displacement.hpp"
#include "lemmas/vocabulary/motion.hpp"
#include "lemmas/vocabulary/slab.hpp"

namespace refitlab {

// These compute (i), for one target and for all of them.
template <class S>
Ball3<S> displaced_by(const Ball3<S>& ball, const Ball3<S>& displacement, const S& weight) {
  return {displaced_by<S>(ball.center, displacement.center, weight), ball.radius + absolute<S>(weight) * displacement.radius};
}
template <class S>
Ball3<S> displaced_ball(const Ball3<S>& reference, std::span<const Ball3<S>> displacements, std::span<const S> weights) {
  Ball3<S> out = reference;
  for (std::size_t k = 0; k < weights.size(); ++k) out = displaced_by<S>(out, displacements[k], weights[k]);
  return out;
}

// These compute (ii) likewise. length is no less than that of the displacements' center. A weight whose range is one number gives
// (i).
template <class S>
Ball3<S> displaced_by(const Ball3<S>& ball, const Ball3<S>& displacement, const Slab<S>& weight, const S& length) {
  const S middle = (weight.low + weight.high) / S(2), half = (weight.high - weight.low) / S(2);
  const S greatest = max_of(absolute<S>(weight.low), absolute<S>(weight.high));
  return {displaced_by<S>(ball.center, displacement.center, middle),
          ball.radius + half * length + greatest * displacement.radius};
}
template <class S>
Ball3<S> displaced_ball(const Ball3<S>& reference, std::span<const Ball3<S>> displacements, std::span<const Slab<S>> weights,
                        std::span<const S> lengths) {
  Ball3<S> out = reference;
  for (std::size_t k = 0; k < weights.size(); ++k) out = displaced_by<S>(out, displacements[k], weights[k], lengths[k]);
  return out;
}

// Returns the products of the numbers of two intervals, as (iii) needs them.
template <class S>
Slab<S> product_of_slabs(const Slab<S>& a, const Slab<S>& b) {
  const S p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return {min_of(min_of(p, q), min_of(r, s)), max_of(max_of(p, q), max_of(r, s))};
}
template <class S>
Slab<S> displaced_slab(const Slab<S>& reference, std::span<const Slab<S>> displacements, std::span<const Slab<S>> weights) {
  Slab<S> out = reference;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Slab<S> more = product_of_slabs(weights[k], displacements[k]);
    out = {out.low + more.low, out.high + more.high};
  }
  return out;
}

// Returns the motion of v by (iv). size is no less than ||v_0||, and lengths[k] is no less than ||d_k||.
template <class S>
Motion<S> displaced_motion(const S& size, std::span<const S> lengths, std::span<const Motion<S>> weights) {
  Motion<S> out = at_rest(size);
  for (std::size_t k = 0; k < weights.size(); ++k) out = out + product(weights[k], at_rest(lengths[k]));
  return out;
}

// --- Hypotheses ---

// A vertex of the reference pose has a displacement for each target.
template <class S>
struct MorphedVertex {
  Vec<S, 3> reference;
  std::vector<Vec<S, 3>> displacements;
};

template <class S>
Verdict morph_hypotheses(const MorphedVertex<S>& vertex, const Ball3<S>& reference, std::span<const Ball3<S>> displacements) {
  Verdict v = encloses(reference, vertex.reference);
  for (std::size_t k = 0; k < displacements.size(); ++k) v &= encloses(displacements[k], vertex.displacements[k]);
  return v;
}

template <class S>
Verdict are_in_ranges(std::span<const S> weights, std::span<const Slab<S>> ranges) {
  Verdict v = Verdict::holds;
  for (std::size_t k = 0; k < weights.size(); ++k)
    v &= less_equal(ranges[k].low, weights[k]) & less_equal(weights[k], ranges[k].high);
  return v;
}

// --- Conclusion ---

template <class S>
Vec<S, 3> displaced(const MorphedVertex<S>& vertex, std::span<const S> weights) {
  Vec<S, 3> v = vertex.reference;
  for (std::size_t k = 0; k < weights.size(); ++k) v = displaced_by<S>(v, vertex.displacements[k], weights[k]);
  return v;
}

// The witness of (i) splits the way from the ball's center to the vertex: the part of the reference, then that of each target.
template <class S>
struct DisplacedVertex {
  Verdict verdict;
  std::vector<Vec<S, 3>> beside;
};

// Checks the witness independently: the parts lead from the center to the vertex, and none is longer than its share of the
// radius.
template <class S>
Verdict is_displaced(const MorphedVertex<S>& vertex, const Ball3<S>& reference, std::span<const Ball3<S>> displacements,
                     std::span<const S> weights, std::span<const Vec<S, 3>> beside) {
  if (beside.size() != weights.size() + 1) return Verdict::fails;
  const Ball3<S> ball = displaced_ball(reference, displacements, weights);
  Verdict v = less_equal(squared_norm(beside[0]), sq(reference.radius));
  Vec<S, 3> sum = beside[0];
  for (std::size_t k = 0; k < weights.size(); ++k) {
    v &= less_equal(squared_norm(beside[k + 1]), sq(S(weights[k] * displacements[k].radius)));
    sum = sum + beside[k + 1];
  }
  const Vec<S, 3> at = displaced(vertex, weights);
  for (int i = 0; i < 3; ++i) v &= equal(S(ball.center[i] + sum[i]), at[i]);
  return v;
}

template <class S>
DisplacedVertex<S> stays_in_displaced_ball(const MorphedVertex<S>& vertex, const Ball3<S>& reference,
                                           std::span<const Ball3<S>> displacements, std::span<const S> weights) {
  DisplacedVertex<S> out{encloses(displaced_ball(reference, displacements, weights), displaced(vertex, weights)),
                         {vertex.reference - reference.center}};
  for (std::size_t k = 0; k < weights.size(); ++k)
    out.beside.push_back((vertex.displacements[k] - displacements[k].center) * weights[k]);
  return out;
}

// Judges (ii).
template <class S>
Verdict stays_in_ball_of_ranges(const MorphedVertex<S>& vertex, const Ball3<S>& reference,
                                std::span<const Ball3<S>> displacements, std::span<const Slab<S>> ranges,
                                std::span<const S> lengths, std::span<const S> weights) {
  return encloses(displaced_ball(reference, displacements, ranges, lengths), displaced(vertex, weights));
}

// --- Erratum: the reference pose's ball ---

// Judges what a refit without morph targets assumes: the displaced vertex is in the reference ball.
template <class S>
Verdict stays_in_reference(const MorphedVertex<S>& vertex, const Ball3<S>& reference, std::span<const S> weights) {
  return encloses(reference, displaced(vertex, weights));
}

}  // namespace refitlab

// Sources: none; for what displaces vertices [James, Pai 2004, "BD-tree: output-sensitive collision detection for reduced
// deformable models"].
// Used by: algorithms/bake/over_time/moving_vertices.cpp, algorithms/runtime/refit/deformed_reference.cpp,
// experiments/drawings/motion.cpp.
