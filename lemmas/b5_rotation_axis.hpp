// SPDX-License-Identifier: MIT
// Beyond the paper: on a twist only the distance from the axis moves.
//
// Statement. Let all quaternions q'_k turn about one axis n (Im q'_k parallel to n, n not 0), and split x = a + p into
// its part along n and its part across. For every blend b = sum u_k q'_k that is not 0, R_b x = a + R_b p with R_b p
// perpendicular to n. So with a cap about c, a rotation about n too, and h = max(2 kappa^2 - 1, 0) as in
// b4_cap_fallback, R_b x is in the ball [a + h R_c p, sqrt(1 - h^2) ||p||], while the paper's has the radius sqrt(1 -
// h^2) ||x||: larger by ||x|| / ||p||, which has no bound. The control points know the axis by themselves: P_kl(x) -
// W_kl a = P_kl(p) is perpendicular to n; for x on the axis P_kl = W_kl x.
//
// Goes beyond: section 4.3, whose cap allows "an arbitrary axis".
// Notation: n -> axis, a -> along, p -> across, P_kl, W_kl as in b1_rational_bezier_simplex.
//
// Proof. Quaternions s + t n are closed under sums and products, commute with the pure quaternion a, and turn a vector
// across n into one across n. The rest is b4_cap_fallback for p in place of x.
#pragma once

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b4_cap_fallback.hpp"
#include "lemmas/s43_minkowski_sum.hpp"

namespace refitlab {

// --- Hypotheses ---

template <class S>
Verdict turns_about(const Vec<S, 3>& axis, const Quaternion<S>& q) {
  const Vec<S, 3> off = cross<S>(imaginary(q), axis);
  return less(S(0), squared_norm(axis)) & equal(off[0], S(0)) & equal(off[1], S(0)) & equal(off[2], S(0));
}

template <class S>
Verdict twist_hypotheses(const Vec<S, 3>& axis, const CapFallback<S>& cap, std::span<const S> u) {
  Verdict v = cap_fallback_hypotheses(cap, u) & turns_about(axis, cap.axis);
  for (const auto& q : cap.rotations) v &= turns_about(axis, q);
  return v;
}

// --- Conclusion ---

template <class S>
struct AxisParts {
  Vec<S, 3> along, across;  // of x
};

template <class S>
AxisParts<S> split_at_axis(const Vec<S, 3>& axis, const Vec<S, 3>& x) {
  const Vec<S, 3> along = axis * (dot(axis, x) / squared_norm(axis));
  return {along, x - along};
}

// Returns the ball of the statement.
template <class S>
SquaredBall<S, 3> twist_ball(const CapFallback<S>& cap, const AxisParts<S>& parts) {
  const SquaredBall<S, 3> of_across = fallback_ball(cap, parts.across);
  return {parts.along + of_across.center, of_across.squared_radius};
}

template <class S>
struct TwistedPoint {
  Verdict verdict;
  AxisParts<S> parts;
  Vec<S, 3> rotated;  // R_b x
};

// Checks the witness independently: x is split into its parts along and across the axis, R_b x keeps the part along it, and R_b x
// is in the ball.
template <class S>
Verdict is_twisted_point(const Vec<S, 3>& axis, const CapFallback<S>& cap, const Vec<S, 3>& x, std::span<const S> u,
                         const TwistedPoint<S>& witness) {
  const auto& [along, across] = witness.parts;
  const Vec<S, 3> off = cross<S>(along, axis), rest = witness.rotated - along;
  Verdict v = equal(dot(across, axis), S(0)) & equal(dot(rest, axis), S(0)) &
              is_rotated<S>(combine<S, 4>(u, cap.rotations), x, witness.rotated) &
              encloses(twist_ball(cap, witness.parts), witness.rotated);
  for (int i = 0; i < 3; ++i) v &= equal(off[i], S(0)) & equal(S(along[i] + across[i]), x[i]);
  return v;
}

template <class S>
TwistedPoint<S> twist_keeps_axis(const Vec<S, 3>& axis, const CapFallback<S>& cap, const Vec<S, 3>& x, std::span<const S> u) {
  TwistedPoint<S> out{Verdict::undecided, split_at_axis(axis, x), rotate_by<S>(combine<S, 4>(u, cap.rotations), x)};
  out.verdict = is_twisted_point(axis, cap, x, u, out);
  return out;
}

// The control points keep the part along the axis too.
template <class S>
Verdict control_points_keep_axis(const Vec<S, 3>& axis, const Quaternion<S>& p, const Quaternion<S>& q, const Vec<S, 3>& x) {
  const AxisParts<S> parts = split_at_axis(axis, x);
  const MixedPair<S> mixed = mix_rotations(p, q, x), of_across = mix_rotations(p, q, parts.across);
  const Vec<S, 3> rest = mixed.numerator - parts.along * mixed.weight, &expected = of_across.numerator;
  Verdict kept = equal(dot(rest, axis), S(0));
  for (int i = 0; i < 3; ++i) kept &= equal(rest[i], expected[i]);
  return implies(turns_about(axis, p) & turns_about(axis, q), kept);
}

}  // namespace refitlab

// Sources: none.
// Used by: experiments/drawings/control_hulls.cpp.
