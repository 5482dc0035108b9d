// SPDX-License-Identifier: MIT
// Beyond the paper: how far off is what a blend makes of a point, if the blend is off.
//
// Statement. Let q + eps d and q' + eps d' be dual quaternions of any length, with ||q' - q|| <= e, and let kappa ||q|| >= 1. If
// q' is not 0, the rotations of every x are near each other:
//   ||R_q' x - R_q x|| <= 2 kappa e ||x||.
// Let also kappa ||q'|| >= 1, ||d' - d|| <= f and ||d|| <= l. Then the translations t(q, d) = 2 Im(d q*) / ||q||^2 are:
//   ||t(q', d') - t(q, d)|| <= 2 kappa (f + kappa e l).
// No factor below 2 kappa will do in the first bound, nor before f in the second.
//
// Goes beyond: section 3, whose blends are those of exact arithmetic.
// Notation: q + eps d, q' + eps d' -> blend, other; e, f, kappa, l -> error.
//
// Proof. R_q and R_q' are those of n = q / ||q|| and n' = q' / ||q'||, and ||R_n' x - R_n x|| <= 2 sqrt(1 - (n, n')^2) ||x||
// (b7_motion_bound). ||q||^2 (1 - (n, n')^2) is the squared distance of q from the line of q', and so at most e^2. Inverses
// i = q* / ||q||^2 and i' are ||q' - q|| / (||q|| ||q'||) apart, and t(q', d') - t(q, d) = 2 Im((d' - d) i' + d (i' - i)).
#pragma once

#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/vocabulary/blending.hpp"

namespace refitlab {

// A BlendError says by how much a blend is off, as lengths of quaternions.
template <class S>
struct BlendError {
  S rotation;        // e
  S dual;            // f
  S dual_length;     // l, of the blend that is not off
  S inverse_length;  // kappa
};

// Returns what multiplies ||x||.
template <class S>
constexpr S turn_of_error(const S& of_rotation, const S& inverse_length) {
  return S(2) * inverse_length * of_rotation;
}

// Returns the bound of the translations.
template <class S>
S move_of_error(const BlendError<S>& error) {
  return S(2) * error.inverse_length * (error.dual + error.inverse_length * error.rotation * error.dual_length);
}

// --- Hypotheses ---

template <class S>
Verdict is_within(const Quaternion<S>& a, const Quaternion<S>& b, const S& distance) {
  return less_equal(S(0), distance) & less_equal(squared_norm<S, 4>(a - b), sq(distance));
}

template <class S>
Verdict is_long(const Quaternion<S>& q, const S& inverse_length) {
  return less_equal(S(0), inverse_length) & less_equal(S(1), S(sq(inverse_length) * squared_norm(q)));
}

template <class S>
Verdict turn_hypotheses(const Quaternion<S>& q, const Quaternion<S>& other, const BlendError<S>& error) {
  return is_within(q, other, error.rotation) & is_long(q, error.inverse_length) & less(S(0), squared_norm(other));
}

template <class S>
Verdict move_hypotheses(const BlendedDuals<S>& blend, const BlendedDuals<S>& other, const BlendError<S>& error) {
  return is_within(blend.rotation, other.rotation, error.rotation) & is_long(blend.rotation, error.inverse_length) &
         is_long(other.rotation, error.inverse_length) & is_within(blend.dual, other.dual, error.dual) &
         is_within(blend.dual, Quaternion<S>(Quaternion<S>::Constant(S(0))), error.dual_length);
}

// --- Conclusion ---

// ImagesOfBlends holds the two images of a point, or two translations.
template <class S>
struct ImagesOfBlends {
  Verdict verdict;
  Vec<S, 3> image, other;
};

// Checks the witness independently: both points are the images of x, and near each other.
template <class S>
Verdict are_turned_images(const Quaternion<S>& q, const Quaternion<S>& other, const Vec<S, 3>& x, const BlendError<S>& error,
                          const ImagesOfBlends<S>& witness) {
  return is_rotated<S>(q, x, witness.image) & is_rotated<S>(other, x, witness.other) &
         less_equal(squared_distance<S, 3>(witness.image, witness.other),
                    S(sq(turn_of_error(error.rotation, error.inverse_length)) * squared_norm(x)));
}

template <class S>
ImagesOfBlends<S> turn_is_little(const Quaternion<S>& q, const Quaternion<S>& other, const Vec<S, 3>& x,
                                 const BlendError<S>& error) {
  ImagesOfBlends<S> out{Verdict::undecided, rotate_by(q, x), rotate_by(other, x)};
  out.verdict = are_turned_images(q, other, x, error, out);
  return out;
}

// Checks that a point is t(q, d), which q carries to 2 Im(d q*) / ||q||^2 without a division.
template <class S>
Verdict is_translation(const BlendedDuals<S>& blend, const Vec<S, 3>& t) {
  const Vec<S, 3> scaled = imaginary<S>(multiply(blend.dual, conjugate(blend.rotation))) * S(2);
  const S squared_length = squared_norm(blend.rotation);
  Verdict v = less(S(0), squared_length);
  for (int i = 0; i < 3; ++i) v &= equal(S(t[i] * squared_length), scaled[i]);
  return v;
}

template <class S>
Verdict are_translations(const BlendedDuals<S>& blend, const BlendedDuals<S>& other, const BlendError<S>& error,
                         const ImagesOfBlends<S>& witness) {
  return is_translation(blend, witness.image) & is_translation(other, witness.other) &
         less_equal(squared_distance<S, 3>(witness.image, witness.other), sq(move_of_error(error)));
}

template <class S>
ImagesOfBlends<S> move_is_little(const BlendedDuals<S>& blend, const BlendedDuals<S>& other, const BlendError<S>& error) {
  const Vec<S, 3> origin = Vec<S, 3>::Constant(S(0));
  ImagesOfBlends<S> out{Verdict::undecided, move_rigidly(blend, squared_norm(blend.rotation), origin),
                        move_rigidly(other, squared_norm(other.rotation), origin)};
  out.verdict = are_translations(blend, other, error, out);
  return out;
}

}  // namespace refitlab

// Sources: none.
// Used by: algorithms/runtime/batch/float_palette.hpp, algorithms/runtime/skinning/palette_rounding.hpp,
// experiments/drawings/control_hulls.cpp.
