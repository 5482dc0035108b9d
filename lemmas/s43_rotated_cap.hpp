// SPDX-License-Identifier: MIT
// Section 4.3, from a cap of rotations on S_3 to a cap of rotated vectors in R^3 ("arbitrary axis and angle").
//
// Statement. For non-zero quaternions p, q with the angle arccos c between them, and any v of R^3,
//   (R_p v, R_q v) >= ||v||^2 (2 c^2 - 1).
// So if C is the cap of S_3 with apex a and angle alpha <= pi/2, then {R_q v : q in C} is inside the cap of R^3 with
// apex R_a v and angle 2 alpha; and it is all of that cap. For alpha > pi/2 it is all of the sphere of radius ||v||.
//
// Paper: section 4.3, after Figure 2: "an arbitrary axis and angle within <0, 2 alpha_C>", without a proof.
// Notation: a_C -> apex, cos alpha_C -> cos_angle, p - r_c -> v, cos of the angle in R^3 -> rotated_cap_cosine.
//
// Proof. With s = p* q the difference of both sides, times ||p||^2 ||q||^2, is 2 (Im s, v)^2. Filled: the shortest
// rotation s from R_a v to x turns by the angle between them, and s a is at half that angle from a.
#pragma once

#include "lemmas/s43_minkowski_sum.hpp"

namespace refitlab {

// --- The rotation bound ---

template <class S>
struct RotationSlack {
  Verdict verdict;
  S slack;       // ||p||^2 ||q||^2 times the left side minus the right
  S along_axis;  // (Im(p* q), v): the slack is twice its square
};

template <class S>
RotationSlack<S> rotation_bound(const Quaternion<S>& p, const Quaternion<S>& q, const Vec<S, 3>& v) {
  const S left = dot(rotate_scaled(p, v), rotate_scaled(q, v));
  const S right = squared_norm(v) * (S(2) * sq(dot(p, q)) - squared_norm(p) * squared_norm(q));
  return {less_equal(right, left), left - right, dot(imaginary(multiply(conjugate(p), q)), v)};
}

// The slack is the difference that is claimed, and it is a square.
template <class S>
Verdict is_rotation_bound(const Quaternion<S>& p, const Quaternion<S>& q, const Vec<S, 3>& v, const RotationSlack<S>& witness) {
  const Vec<S, 3> a = rotate_scaled(p, v), b = rotate_scaled(q, v);
  const S right = squared_norm(v) * (S(2) * sq(dot(p, q)) - squared_norm(p) * squared_norm(q));
  return equal(S(dot(a, b) - right), witness.slack) & equal(witness.slack, S(S(2) * sq(witness.along_axis)));
}

// --- Caps: membership without square roots ---

// (a, x) >= cos_angle ||a|| ||x||, for vectors of any length.
template <class S, int D>
Verdict within_angle(const Vec<S, D>& a, const Vec<S, D>& x, const S& cos_angle) {
  const S along = dot(a, x);
  const S squares = sq(cos_angle) * squared_norm(a) * squared_norm(x);
  const Verdict ahead = less_equal(S(0), along);
  const Verdict narrow = ahead & less_equal(squares, sq(along)), wide = ahead | less_equal(sq(along), squares);
  const Verdict acute = less_equal(S(0), cos_angle);
  return (acute & narrow) | (!acute & wide);
}

// --- Hypotheses ---

// q is a rotation of the cap about a.
template <class S>
Verdict rotated_cap_hypotheses(const Quaternion<S>& apex, const S& cos_angle, const Quaternion<S>& q) {
  return less(S(0), squared_norm(apex)) & less(S(0), squared_norm(q)) & within_angle<S, 4>(apex, q, cos_angle);
}

// x is on the sphere of v and within the rotated cap.
template <class S>
Verdict filled_cap_hypotheses(const Quaternion<S>& apex, const Vec<S, 3>& v, const Vec<S, 3>& x, const S& rotated_cosine) {
  return less(S(0), squared_norm(apex)) & equal(squared_norm(x), squared_norm(v)) &
         within_angle<S, 3>(rotate_scaled(apex, v), x, rotated_cosine);
}

// --- Erratum: the doubled angle ---
// The paper allows alpha_C up to pi. Past pi/2 the doubled angle is past pi, and its cosine rises again.

// Printed: cos(2 alpha_C) = 2 cos^2 alpha_C - 1, whatever the angle.
template <class S>
S rotated_cap_cosine_printed(const S& cos_angle) {
  return S(2) * sq(cos_angle) - S(1);
}

// Printed: sin(2 alpha_C) = 2 cos alpha_C sin alpha_C, negative past pi/2; takes a root.
template <class S>
S rotated_cap_sine_printed(const S& cos_angle) {
  return S(2) * cos_angle * root(S(S(1) - sq(cos_angle)));
}

// Repaired: a cap past pi/2 holds rotations by pi, so the whole sphere is reached.
template <class S>
S rotated_cap_cosine_repaired(const S& cos_angle) {
  return S(2) * sq(max_of(cos_angle, S(0))) - S(1);
}

// Returns 1 - cos(2 alpha_C) from the squared half chord s^2 of alpha_C. It is ||n - a||^2 / 4 for a unit n on the rim and a unit
// apex: cos alpha_C = 1 - 2 s^2, so 1 - cos(2 alpha_C) = 8 s^2 (1 - s^2). It keeps all digits at small angles, where a cosine
// loses half of them. This is for s^2 <= 1/2; beyond that, the whole sphere is reached.
template <class S>
S rotated_cap_versine(const S& squared_half_chord) {
  return S(8) * squared_half_chord * (S(1) - squared_half_chord);
}

// --- Conclusion ---

// R_q v is within the angle with the given cosine of R_a v. The witness is the rotated pair.
template <class S>
struct RotatedPair {
  Verdict verdict;
  Vec<S, 3> at_apex, rotated;  // R_a v and R_q v
};

template <class S>
Verdict is_rotated_pair(const Quaternion<S>& apex, const Quaternion<S>& q, const Vec<S, 3>& v, const S& rotated_cosine,
                        const RotatedPair<S>& witness) {
  return is_rotated(apex, v, witness.at_apex) & is_rotated(q, v, witness.rotated) &
         less_equal(S(squared_norm(v) * rotated_cosine), dot(witness.at_apex, witness.rotated));
}

template <class S>
RotatedPair<S> rotated_cap(const Quaternion<S>& apex, const Quaternion<S>& q, const Vec<S, 3>& v, const S& rotated_cosine) {
  const Vec<S, 3> at_apex = rotate_by(apex, v), rotated = rotate_by(q, v);
  return {less_equal(S(squared_norm(v) * rotated_cosine), dot(at_apex, rotated)), at_apex, rotated};
}

// The rotated cap is filled. The witness is a rotation of the cap that takes v to x.
template <class S>
struct RotationOnto {
  Verdict verdict;
  Quaternion<S> rotation;  // of any length
};

template <class S>
Verdict is_rotation_onto(const Quaternion<S>& apex, const S& cos_angle, const Vec<S, 3>& v, const Vec<S, 3>& x,
                         const Quaternion<S>& rotation) {
  return rotated_cap_hypotheses(apex, cos_angle, rotation) & is_rotated(rotation, v, x);
}

template <class S>
RotationOnto<S> rotation_onto(const Quaternion<S>& apex, const S& cos_angle, const Vec<S, 3>& v, const Vec<S, 3>& x) {
  const Vec<S, 3> u = rotate_by(apex, v);
  const Vec<S, 3> axis = cross(u, x);
  // This is the shortest rotation from u to x. It is half a turn about any perpendicular axis if x = -u, and none if v = 0.
  Quaternion<S> shortest = {squared_norm(v) + dot(u, x), axis[0], axis[1], axis[2]};
  if (!certainly_less(S(0), shortest[0])) {
    if (equal(squared_norm(u), S(0)) == Verdict::holds) shortest = identity_quaternion<S>();
    else if (certainly_less(S(0), S(sq(u[0]) + sq(u[1])))) shortest = {S(0), -u[1], u[0], S(0)};
    else shortest = {S(0), S(1), S(0), S(0)};
  }
  const Quaternion<S> rotation = multiply(shortest, apex);
  return {is_rotation_onto(apex, cos_angle, v, x, rotation), rotation};
}

}  // namespace refitlab

// Sources: the paper; the bound is Rodrigues' formula for (v, R_s v) in half angles.
// Used by: rotation_bound, s43_whole_sphere_fallback, t3_one_cap; algorithms/methods/refit/algorithm1_printed.hpp,
// experiments/drawings/one_cap.cpp, experiments/drawings/sections.cpp.
