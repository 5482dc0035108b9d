// SPDX-License-Identifier: MIT
// Section 4.3, turning a ball is turning its center: Q_w(S - r_c) = Q_w(p - r_c) (+) [0, r], a Minkowski sum.
//
// Statement. Let q be a non-zero quaternion, R_q its rotation, S = [p, r] a ball of R^3 and c a point. Then
// {R_q(v - c) : v in S} = {R_q(p - c) + y : ||y|| <= r}. Uniting over the blends q = q(w) gives the paper's equation.
//
// Paper: section 4.3, first equation. It holds as printed, for blends that are not 0.
// Notation: S = [p, r] -> ball, r_c -> pivot, q(w) -> blend, Q_w x -> the x' with ||q||^2 x' = Im(q x q*).
//
// The relation ||q||^2 x' = Im(q x q*) is used in place of the quotient, so that a rational q of any length gives an
// exact statement, and so that a zero blend shows up as what it is: a relation that holds for every x'.
#pragma once

#include "lemmas/vocabulary/quaternion.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns the rotated x, Im(q x q*) / ||q||^2, for a non-zero quaternion of any length.
template <class S>
Vec<S, 3> rotate_by(const Quaternion<S>& q, const Vec<S, 3>& x) {
  return rotate_scaled(q, x) / squared_norm(q);
}

// ||q||^2 x' = Im(q x q*).
template <class S>
Verdict is_rotated(const Quaternion<S>& q, const Vec<S, 3>& x, const Vec<S, 3>& image) {
  const Vec<S, 3> scaled = rotate_scaled(q, x);
  const S length = squared_norm(q);
  Verdict v = Verdict::holds;
  for (int i = 0; i < 3; ++i) v &= equal(S(length * image[i]), scaled[i]);
  return v;
}

// --- Hypotheses ---

// The blend stands for a rotation.
template <class S>
Verdict minkowski_sum_hypotheses(const Quaternion<S>& blend) {
  return less(S(0), squared_norm(blend));
}

// --- Witness and its check ---

// The witness is one point of both sets, R_q(v - c) = R_q(p - c) + y.
template <class S>
struct TurnedPoint {
  Vec<S, 3> point;   // v, in the ball
  Vec<S, 3> offset;  // y, in the ball of the same radius about 0
  Vec<S, 3> turned_center, turned_point;
};

template <class S>
Verdict is_turned_point(const Quaternion<S>& blend, const Ball3<S>& ball, const Vec<S, 3>& pivot, const TurnedPoint<S>& witness) {
  Verdict v = encloses(ball, witness.point) & less_equal(squared_norm(witness.offset), sq(ball.radius)) &
              is_rotated<S>(blend, ball.center - pivot, witness.turned_center) &
              is_rotated<S>(blend, witness.point - pivot, witness.turned_point);
  for (int i = 0; i < 3; ++i) v &= equal(S(witness.turned_center[i] + witness.offset[i]), witness.turned_point[i]);
  return v;
}

// --- Conclusion ---

template <class S>
struct MinkowskiSum {
  Verdict verdict;
  TurnedPoint<S> witness;
};

// A turned point of the ball is in the sum.
template <class S>
MinkowskiSum<S> turned_ball_in_sum(const Quaternion<S>& blend, const Ball3<S>& ball, const Vec<S, 3>& pivot,
                                   const Vec<S, 3>& point) {
  const Vec<S, 3> center = rotate_by<S>(blend, ball.center - pivot), turned = rotate_by<S>(blend, point - pivot);
  const TurnedPoint<S> witness{point, turned - center, center, turned};
  return {is_turned_point(blend, ball, pivot, witness), witness};
}

// A point of the sum is a turned point of the ball.
template <class S>
MinkowskiSum<S> sum_in_turned_ball(const Quaternion<S>& blend, const Ball3<S>& ball, const Vec<S, 3>& pivot,
                                   const Vec<S, 3>& offset) {
  const Vec<S, 3> center = rotate_by<S>(blend, ball.center - pivot);
  const TurnedPoint<S> witness{ball.center + rotate_by(conjugate(blend), offset), offset, center, center + offset};
  return {is_turned_point(blend, ball, pivot, witness), witness};
}

}  // namespace refitlab

// Sources: the paper.
// Used by: b4_cap_fallback, b5_rotation_axis, b8_blend_error, s43_rotated_cap, s44_joint_sets;
// experiments/drawings/control_hulls.cpp, experiments/drawings/sections.cpp,
// experiments/explorer/pages/whole_sphere.hpp.
