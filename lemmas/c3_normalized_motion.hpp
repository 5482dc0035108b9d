// SPDX-License-Identifier: MIT
// Beyond the paper: how a quaternion moves that is normalised after it was blended, by how the blend moves.
//
// Statement. Let p be a curve in R^4 with ||p|| >= m > 0, ||p'|| <= L and ||p''|| <= A. Then
// (i) q = p / ||p|| has ||q'|| <= L / m and ||q''|| <= A / m + 2/sqrt(3) (L / m)^2;
// (ii) g = p / ||p||^2 has ||g|| <= 1 / m, ||g'|| <= L / m^2 and ||g''|| <= A / m^2 + 2 L^2 / m^3.
// Both are sharp at a moment with ||p|| = m, but for (i) where A > 0. For m:
// (iii) if p = sum w_k q_k with w of W_n, all ||q_k||^2 >= d, which is 1 for unit quaternions, and all (q_k, q_l) >= c for
//   k != l, where c <= d, then ||p||^2 >= c + (d - c) / n;
//   For given w, ||q_k|| >= 1 and all (q_k, q_l) >= c_kl, ||p||^2 >= sum w_k^2 + 2 sum_{k<l} w_k w_l c_kl;
// (iv) if p is a convex combination of p_k, and a any vector but 0, then ||p|| >= min_k (p_k, a) / ||a||.
// Where none of them is positive p may vanish, and there is no bound: near 0 a blend turns as fast as it wants to.
//
// Replaces: nothing in the paper, which bounds one pose at a time.
// Notation: p -> blend, m -> least, L and A -> motion, c -> cosine. 2/sqrt(3) is rounded up to 37/32, exact in binary.
//
// Proof. Let n = ||p||, p' = y q + x e with unit e perpendicular to q, so x^2 + y^2 = ||p'||^2 and n q' = x e. With b the part of
// p'' across q: n q'' = b - 2 (y / n) x e - (x^2 / n) q.
// (i) ||q''|| <= ||b|| / n + |(2 x y, x^2)| / n^2, and x^2 (4 y^2 + x^2) = x^2 (4 ||p'||^2 - 3 x^2) <= 4/3 ||p'||^4.
// (ii) n^2 g'' = (p'' reflected in q) + 2/n ((y^2 - x^2) q - 2 x y e), whose last bracket has the length x^2 + y^2; g' is p'
//   reflected, over n^2.
// (iii) ||p||^2 = sum w_k^2 ||q_k||^2 + sum_{k != l} w_k w_l (q_k, q_l) >= d s + c (1 - s), s = sum w_k^2 >= 1 / n, and c <= d.
// (iv) ||p|| ||a|| >= (p, a), a convex combination of the (p_k, a).
#pragma once

#include "lemmas/vocabulary/motion.hpp"
#include "lemmas/vocabulary/quaternion.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// Returns the motion of (i). It does not use the blend's size.
template <class S>
Motion<S> normalized_motion(const Motion<S>& blend, const S& least) {
  const S turn = blend.speed / least;
  return {S(1), turn, blend.acceleration / least + S(37) / S(32) * sq(turn)};
}

// Returns the motion of (ii).
template <class S>
Motion<S> inverse_motion(const Motion<S>& blend, const S& least) {
  const S turn = blend.speed / least;
  return {S(1) / least, turn / least, (blend.acceleration / least + S(2) * sq(turn)) / least};
}

// Returns m^2 of (iii). count is no less than the number of quaternions, and squared_length is d.
template <class S>
S least_squared_blend(const S& cosine, const S& count, const S& squared_length = S(1)) {
  return cosine + (squared_length - cosine) / count;
}

// Returns the squared length of the blend with given weights. cosines are the c_kl for k < l in order.
template <class S>
S least_squared_blend(std::span<const S> w, std::span<const S> cosines) {
  S sum(0);
  std::size_t pair = 0;
  for (std::size_t k = 0; k < w.size(); ++k) {
    sum = sum + sq(w[k]);
    for (std::size_t l = k + 1; l < w.size(); ++l) sum = sum + S(2) * w[k] * w[l] * cosines[pair++];
  }
  return sum;
}

// Returns m ||a|| of (iv).
template <class S>
S least_along(std::span<const Quaternion<S>> blended, const Quaternion<S>& axis) {
  S least = dot(blended[0], axis);
  for (const Quaternion<S>& p : blended.subspan(1)) least = min_of(least, dot(p, axis));
  return least;
}

// --- Hypotheses ---

template <class S>
Verdict normalization_hypotheses(const Moment<S, 4>& blend, const Motion<S>& motion, const S& least) {
  return less(S(0), least) & less_equal(sq(least), squared_norm(blend.value)) & is_motion(motion) &
         less_equal(squared_norm(blend.velocity), sq(motion.speed)) &
         less_equal(squared_norm(blend.acceleration), sq(motion.acceleration));
}

// Judges the hypotheses of (iii): the quaternions are units, and no dot product is below the cosine.
template <class S>
Verdict are_close_units(std::span<const Quaternion<S>> units, const S& cosine) {
  Verdict v = less_equal(cosine, S(1));
  for (std::size_t k = 0; k < units.size(); ++k) {
    v &= equal(squared_norm(units[k]), S(1));
    for (std::size_t l = 0; l < k; ++l) v &= less_equal(cosine, dot(units[k], units[l]));
  }
  return v;
}

// --- Conclusion ---

// The witness of (i) is ||p|| q' and ||p|| q'', which need no root.
template <class S>
struct NormalizedMoment {
  Verdict verdict;
  Quaternion<S> velocity, acceleration;
};

// x is a multiple of p.
template <class S>
Verdict is_along(const Quaternion<S>& x, const Quaternion<S>& p) {
  Verdict v = Verdict::holds;
  const S length = squared_norm(p), along = dot(x, p);
  for (int i = 0; i < 4; ++i) v &= equal(S(x[i] * length), S(p[i] * along));
  return v;
}

// Checks the witness independently: q stays of length 1, p' and p'' are those of ||p|| q, and both are within the bounds.
template <class S>
Verdict is_normalized_moment(const Moment<S, 4>& blend, const Motion<S>& motion, const S& least,
                             const NormalizedMoment<S>& witness) {
  const S length = squared_norm(blend.value), stretch = dot(blend.value, blend.velocity);
  const Quaternion<S> rest = (blend.acceleration - witness.acceleration) * length - witness.velocity * S(S(2) * stretch);
  const Motion<S> bounds = normalized_motion(motion, least);
  return equal(dot(blend.value, witness.velocity), S(0)) &
         equal(dot(blend.value, witness.acceleration), S(-squared_norm(witness.velocity))) &
         is_along<S>(blend.velocity - witness.velocity, blend.value) & is_along<S>(rest, blend.value) &
         less_equal(squared_norm(witness.velocity), S(length * sq(bounds.speed))) &
         less_equal(squared_norm(witness.acceleration), S(length * sq(bounds.acceleration)));
}

template <class S>
NormalizedMoment<S> normalized_moves(const Moment<S, 4>& blend, const Motion<S>& motion, const S& least) {
  const Quaternion<S>&p = blend.value, &v = blend.velocity, &a = blend.acceleration;
  const S length = squared_norm(p), stretch = dot(p, v) / length;
  const S back = (squared_norm(v) + dot(p, a)) / length - S(3) * sq(stretch);
  NormalizedMoment<S> out{Verdict::undecided, v - p * stretch, a - v * S(S(2) * stretch) - p * back};
  const Motion<S> bounds = normalized_motion(motion, least);
  out.verdict = less_equal(squared_norm(out.velocity), S(length * sq(bounds.speed))) &
                less_equal(squared_norm(out.acceleration), S(length * sq(bounds.acceleration)));
  return out;
}

// The witness of (ii) is the inverse with both derivatives.
template <class S>
struct InverseMoment {
  Verdict verdict;
  Moment<S, 4> moment;
};

// ||q||^2 times the quotient is the dividend, and so are the first two derivatives. This takes no quotients.
template <class S, int D>
Verdict is_divided(const Moment<S, 4>& q, const Moment<S, D>& quotient, const Moment<S, D>& dividend) {
  const S length = squared_norm(q.value), faster = S(2) * dot(q.value, q.velocity),
          bend = S(2) * (squared_norm(q.velocity) + dot(q.value, q.acceleration));
  Verdict v = Verdict::holds;
  for (int i = 0; i < D; ++i)
    v &= equal(S(length * quotient.value[i]), dividend.value[i]) &
         equal(S(length * quotient.velocity[i] + faster * quotient.value[i]), dividend.velocity[i]) &
         equal(S(length * quotient.acceleration[i] + S(2) * faster * quotient.velocity[i] + bend * quotient.value[i]),
               dividend.acceleration[i]);
  return v;
}

// Checks the witness independently: ||p||^2 g = p, with both derivatives, and g moves within the bounds.
template <class S>
Verdict is_inverse_moment(const Moment<S, 4>& blend, const Motion<S>& motion, const S& least, const Moment<S, 4>& witness) {
  return moves_within(witness, inverse_motion(motion, least)) & is_divided<S, 4>(blend, witness, blend);
}

template <class S>
InverseMoment<S> inverse_moves(const Moment<S, 4>& blend, const Motion<S>& motion, const S& least) {
  const Quaternion<S>&p = blend.value, &v = blend.velocity, &a = blend.acceleration;
  const S length = squared_norm(p), stretch = S(2) * dot(p, v) / length, bend = S(2) * (squared_norm(v) + dot(p, a)) / length;
  const Quaternion<S> value = p / length, velocity = v / length - value * stretch;
  const Moment<S, 4> moment{value, velocity, a / length - velocity * S(S(2) * stretch) - value * bend};
  return {moves_within(moment, inverse_motion(motion, least)), moment};
}

// Judges (iii).
template <class S>
Verdict blend_is_long(std::span<const Quaternion<S>> blended, const S& cosine, std::span<const S> w,
                      const S& squared_length = S(1)) {
  const S least = least_squared_blend(cosine, S(static_cast<int>(blended.size())), squared_length);
  return less_equal(least, squared_norm(combine<S, 4>(w, blended)));
}

// Judges (iv): m is at most 0, or the blend is at least as long as m.
template <class S>
Verdict blend_is_long_by_axis(std::span<const Quaternion<S>> blended, const Quaternion<S>& axis, std::span<const S> w) {
  const S least = least_along(blended, axis);
  return less_equal(least, S(0)) | less_equal(sq(least), S(squared_norm(axis) * squared_norm(combine<S, 4>(w, blended))));
}

// --- Erratum: as if a blend were not normalised ---

// Judges the quaternion by the blend's own bounds. They are too small wherever the blend is shorter than 1.
template <class S>
Verdict moves_like_its_blend(const Moment<S, 4>& blend, const Motion<S>& motion) {
  return normalized_moves(blend, motion, S(1)).verdict;
}

}  // namespace refitlab

// Sources: none.
// Used by: c5_skinned_motion, c7_crossfade; algorithms/bake/over_time/moving_vertices.cpp,
// algorithms/bake/over_time/node_motions.cpp, algorithms/runtime/skinning/palette_rounding.hpp,
// experiments/drawings/motion.cpp.
