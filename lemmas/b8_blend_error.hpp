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
// Let v'(w) = R_q (v - c) + sum w_k C_k c, q = sum w_k q_k, be the spherical blend of a point v about a center c, of rigid C_k with
// the rotations R_k of unit q_k, for convex weights w. Let w' be convex too, sum |w'_k - w_k| <= e, kappa ||q|| >= 1 and kappa ||q'||
// >= 1, and for some o and y let all ||C_k v - o|| <= a and all ||R_k (v - c) - y|| <= s. Then
//   ||v'(w') - v'(w)|| <= e (a + s) + 2 kappa (e s / 2 + kappa e s / 2) = e (a + s (1 + kappa + kappa^2)).
//
// Goes beyond: section 3, whose blends are those of exact arithmetic.
// Notation: q + eps d, q' + eps d' -> blend, other; e, f, kappa, l, a, s -> error.
//
// Proof. R_q and R_q' are those of n = q / ||q|| and n' = q' / ||q'||, and ||R_n' x - R_n x|| <= 2 sqrt(1 - (n, n')^2) ||x||
// (b7_motion_bound). ||q||^2 (1 - (n, n')^2) is the squared distance of q from the line of q', and so at most e^2. Inverses
// i = q* / ||q||^2 and i' are ||q' - q|| / (||q|| ||q'||) apart, and t(q', d') - t(q, d) = 2 Im((d' - d) i' + d (i' - i)).
// For the spherical blend let u = v - c, d_k = R_k u - y, and d = sum w_k d_k q_k / 2. Since (R_k u) q_k = q_k u, R_q u = Im(q u q*) /
// ||q||^2 is y + t(q, d). And C_k c = C_k v - R_k u, so v'(w) = t(q, d) + sum w_k (C_k v - o) - sum w_k d_k + o. Of the summands, q
// changes by e at most, d by e s / 2, and ||d|| <= s / 2; the two sums change by e a and e s.
#pragma once

#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/vocabulary/blending.hpp"
#include "lemmas/vocabulary/weights.hpp"

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

// A ChangeOfWeights says by how much weights of a spherical blend change, and how far apart the joints carry the point.
template <class S>
struct ChangeOfWeights {
  S weights;         // e
  S image;           // a
  S turned;          // s
  S inverse_length;  // kappa
};

// Returns the bound of spherical blends.
template <class S>
S spherical_move_of_error(const ChangeOfWeights<S>& error) {
  const S half = error.turned / S(2);
  return error.weights * (error.image + error.turned) +
         move_of_error<S>({error.weights, error.weights * half, half, error.inverse_length});
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

// A PointOfJoints is a point that joints carry, about a center. from and middle are o and y.
template <class S>
struct PointOfJoints {
  std::vector<RigidTransform<S>> transforms;
  Vec<S, 3> center, point, from, middle;
};

template <class S>
Verdict spherical_move_hypotheses(const PointOfJoints<S>& of, std::span<const S> w, std::span<const S> other,
                                  const ChangeOfWeights<S>& error) {
  const std::span<const RigidTransform<S>> transforms(of.transforms);
  Verdict v = is_convex(w) & is_convex(other) & less_equal(S(0), error.image) & less_equal(S(0), error.turned);
  S change(0);
  for (std::size_t k = 0; k < transforms.size(); ++k) {
    const Quaternion<S>& q = transforms[k].rotation;
    change = change + absolute<S>(other[k] - w[k]);
    v &= equal(squared_norm(q), S(1)) &
         less_equal(squared_distance<S, 3>(apply(transforms[k], of.point), of.from), sq(error.image)) &
         less_equal(squared_distance<S, 3>(rotate<S>(q, of.point - of.center), of.middle), sq(error.turned));
  }
  return v & less_equal(change, error.weights) & is_long(blended_rotation(transforms, w), error.inverse_length) &
         is_long(blended_rotation(transforms, other), error.inverse_length);
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

// Checks that a point is v'(w), without a division.
template <class S>
Verdict is_spherical_image(const PointOfJoints<S>& of, std::span<const S> w, const Vec<S, 3>& image) {
  Vec<S, 3> turned = image;
  for (std::size_t k = 0; k < w.size(); ++k) turned = turned - apply(of.transforms[k], of.center) * w[k];
  return is_rotated<S>(blended_rotation<S>(of.transforms, w), of.point - of.center, turned);
}

template <class S>
Verdict are_spherical_images(const PointOfJoints<S>& of, std::span<const S> w, std::span<const S> other,
                             const ChangeOfWeights<S>& error, const ImagesOfBlends<S>& witness) {
  return is_spherical_image(of, w, witness.image) & is_spherical_image(of, other, witness.other) &
         less_equal(squared_distance<S, 3>(witness.image, witness.other), sq(spherical_move_of_error(error)));
}

template <class S>
ImagesOfBlends<S> spherical_move_is_little(const PointOfJoints<S>& of, std::span<const S> w, std::span<const S> other,
                                           const ChangeOfWeights<S>& error) {
  ImagesOfBlends<S> out{Verdict::undecided, spherical_blend<S>(of.transforms, w, of.center, of.point),
                        spherical_blend<S>(of.transforms, other, of.center, of.point)};
  out.verdict = are_spherical_images(of, w, other, error, out);
  return out;
}

}  // namespace refitlab

// Sources: none.
// Used by: algorithms/bake/over_time/moving_vertices.cpp, algorithms/runtime/batch/float_palette.hpp,
// algorithms/runtime/skinning/palette_rounding.hpp, experiments/drawings/control_hulls.cpp.
