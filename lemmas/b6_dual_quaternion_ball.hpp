// SPDX-License-Identifier: MIT
// Beyond the paper: a ball around what dual quaternions make of a point, as long as their blends keep away from 0.
//
// Statement. Let q_k + eps d_k, k = 1 ... m, be the weight vertices of a dual quaternion blend
// (b1_rational_bezier_simplex), of any length, p its point and f any other, and a an axis of R^4 with all (q_k, a) > 0.
//   With E_k = 2 d_k + q_k p - f q_k   (p and f as pure quaternions),
// no blend with u in W_m is 0, and all v'(u) are in the ball about f of radius ||a|| max_k ||E_k|| / (q_k, a). For a weight
// vertex that is not 0 and whose image is v'_k,
//   ||E_k||^2 = ||q_k||^2 ||v'_k - f||^2 + 4 (d_k, q_k)^2 / ||q_k||^2:
// of unit dual quaternions it is the distance of the image from f, which the ball exceeds by 1 / cosine of the angle
// from the axis. An axis is there if and only if 0 is not in the hull of the q_k; if it is, there may be no ball: near
// a blend that is 0 vertices are carried as far as wanted, other than in spherical blending (b4_cap_fallback).
//
// Replaces: the cap of b4_cap_fallback, for dual quaternions.
// Notation: q_k, d_k, p -> blend; a -> axis, f -> center, E_k -> reach_at, u -> coefficients.
//
// Proof. With E = sum u_k E_k and q = sum u_k q_k: Im(E q*) = ||q||^2 (v' - f), as f is pure. So ||v' - f|| <= ||E|| /
// ||q||. With M = max_k ||E_k|| / (q_k, a): ||E|| <= sum u_k ||E_k|| <= M (q, a) <= M ||q|| ||a||, and (q, a) > 0. For
// the length, E_k q_k* has the imaginary part ||q_k||^2 (v'_k - f) and the real part 2 (d_k, q_k).
#pragma once

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace refitlab {

// Returns E_k.
template <class S>
Quaternion<S> reach_of(const BlendedDuals<S>& weight_vertex, const Vec<S, 3>& point, const Vec<S, 3>& center) {
  return weight_vertex.dual * S(2) + multiply(weight_vertex.rotation, pure_quaternion(point)) -
         multiply(pure_quaternion(center), weight_vertex.rotation);
}

template <class S>
Quaternion<S> reach_at(const DualQuaternionBlend<S>& blend, std::size_t k, const Vec<S, 3>& center) {
  return reach_of<S>({blend.rotations[k], blend.duals[k]}, blend.point, center);
}

// Returns ||E_k||^2 / (q_k, a)^2. The squared radius is the greatest of these, times ||a||^2.
template <class S>
S squared_reach(const BlendedDuals<S>& weight_vertex, const Vec<S, 3>& point, const Quaternion<S>& axis,
                const Vec<S, 3>& center) {
  return squared_norm(reach_of(weight_vertex, point, center)) / sq(dot(weight_vertex.rotation, axis));
}

// Returns the ball of the statement.
template <class S>
SquaredBall<S, 3> dual_quaternion_ball(std::span<const BlendedDuals<S>> weight_vertices, const Vec<S, 3>& point,
                                       const Quaternion<S>& axis, const Vec<S, 3>& center) {
  S greatest(0);
  for (const BlendedDuals<S>& c : weight_vertices) greatest = max_of(greatest, squared_reach(c, point, axis, center));
  return {center, greatest * squared_norm(axis)};
}
template <class S>
SquaredBall<S, 3> dual_quaternion_ball(const DualQuaternionBlend<S>& blend, const Quaternion<S>& axis, const Vec<S, 3>& center) {
  std::vector<BlendedDuals<S>> weight_vertices;
  for (std::size_t k = 0; k < blend.weight_vertex_count(); ++k) weight_vertices.push_back({blend.rotations[k], blend.duals[k]});
  return dual_quaternion_ball<S>(weight_vertices, blend.point, axis, center);
}

// --- Hypotheses ---

template <class S>
Verdict are_strictly_ahead(const std::vector<Quaternion<S>>& rotations, const Quaternion<S>& axis) {
  Verdict v = Verdict::holds;
  for (const auto& q : rotations) v &= less(S(0), dot(q, axis));
  return v;
}

template <class S>
Verdict dual_quaternion_ball_hypotheses(const DualQuaternionBlend<S>& blend, const Quaternion<S>& axis, std::span<const S> u) {
  return are_strictly_ahead(blend.rotations, axis) & is_convex(u);
}

// --- Conclusion ---

// The witness is the image and E.
template <class S>
struct ReachedImage {
  Verdict verdict;
  Vec<S, 3> image;      // v'(u)
  Quaternion<S> reach;  // E
};

// Checks the witness independently, by the steps of the proof: the blend is not 0, ||q||^2 v' is what the skinning makes, E leads
// to it from f, and E is short enough.
template <class S>
Verdict is_reached_image(const DualQuaternionBlend<S>& blend, const Quaternion<S>& axis, const SquaredBall<S, 3>& ball,
                         std::span<const S> u, const ReachedImage<S>& witness) {
  const ScaledPoint<S> at = blend.at(u);
  const Quaternion<S> q = combine<S, 4>(u, blend.rotations);
  const Vec<S, 3> led = imaginary(multiply(witness.reach, conjugate(q)));
  Verdict v = less(S(0), at.denominator) & is_blended_image(blend, u, witness.image) &
              less_equal(S(squared_norm(witness.reach) * squared_norm(axis)), S(ball.squared_radius * sq(dot(q, axis))));
  for (int i = 0; i < 3; ++i) v &= equal(led[i], S(at.denominator * (witness.image[i] - ball.center[i])));
  return v;
}

template <class S>
ReachedImage<S> dual_quaternion_ball_encloses(const DualQuaternionBlend<S>& blend, const Quaternion<S>& axis,
                                              const Vec<S, 3>& center, std::span<const S> u) {
  const ScaledPoint<S> at = blend.at(u);
  ReachedImage<S> out{Verdict::undecided, at.numerator / at.denominator, Quaternion<S>::Constant(S(0))};
  for (std::size_t k = 0; k < blend.weight_vertex_count(); ++k) out.reach = out.reach + reach_at(blend, k, center) * u[k];
  out.verdict = encloses(dual_quaternion_ball(blend, axis, center), out.image);
  return out;
}

// Judges the formula for ||E_k||^2 of a weight vertex that is not 0.
template <class S>
Verdict reach_is_distance(const DualQuaternionBlend<S>& blend, std::size_t k, const Vec<S, 3>& center) {
  const Quaternion<S>& q = blend.rotations[k];
  const ControlPoint<S> weight_vertex = blend.control_point({k, k});
  const S distance = squared_distance<S, 3>(weight_vertex.numerator / weight_vertex.weight, center);
  return equal(squared_norm(reach_at(blend, k, center)),
               S(weight_vertex.weight * distance + S(4) * sq(dot(blend.duals[k], q)) / weight_vertex.weight));
}

}  // namespace refitlab

// Sources: none; for the blending [Kavan, Collins, Zara, O'Sullivan 2007, "Skinning with dual quaternions"].
// Used by: algorithms/certificate/bound.cpp, algorithms/runtime/refit/refit_dual_quaternion.hpp,
// experiments/drawings/control_hulls.cpp.
