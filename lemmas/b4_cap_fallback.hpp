// SPDX-License-Identifier: MIT
// Beyond the paper: where the control points are no bound, the cap of the rotations still is.
//
// Statement. Let q'_k, c and kappa^2 be as in t3_one_cap with c not 0, or let kappa^2 <= 1/2 and q'_k, c be anything.
// With h = max(2 kappa^2 - 1, 0), every vertex v' = R_b x + sum u_k r'_k + y with u in W_m, b = sum u_k q'_k not 0 and
// ||y|| <= r is in the hull of the balls [r'_k + h R_c x, sqrt(1 - h^2) ||x|| + r], whatever the signs of the W_kl =
// (q'_k, q'_l). If all W_kl >= 0 and no q'_k is 0, the cap about c = sum q'_k is there too: all (q'_k, c) > 0. So the
// control hull asks for more than the cap; but neither bound is inside the other (for two weight vertices apart by a
// rotation of more than a right angle, a control point of degree 2 is outside the cap's ball; on a twist the cap is larger,
// b5_rotation_axis).
//
// Replaces: lines 12 to 15 of Algorithm 1, and "take all of S_3" for r_E >= 1 (section 4.3).
// Notation: q'_k, c, kappa^2 -> rotations, axis, squared_cosine; h -> height; r'_k -> center_images; y -> offset.
//
// Proof. R_b x is within the angle of cosine h of R_c x or, for h = 0, anywhere at distance ||x||: by Lemma 5 it is in
// the ball [h R_c x, sqrt(1 - h^2) ||x||]. Then add the same combination of the r'_k, and y (s44_sum_of_bounds).
#pragma once

#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/t3_one_cap.hpp"

namespace refitlab {

template <class S>
struct CapFallback {
  std::vector<Quaternion<S>> rotations;  // q'_k
  std::vector<Vec<S, 3>> center_images;  // r'_k
  Quaternion<S> axis;                    // c
  S squared_cosine;                      // kappa^2
};

// Returns h.
template <class S>
S fallback_height(const CapFallback<S>& cap) {
  return max_of(S(S(2) * cap.squared_cosine - S(1)), S(0));
}

// Returns the ball that is added to each r'_k. It holds the rotated x.
template <class S>
SquaredBall<S, 3> fallback_ball(const CapFallback<S>& cap, const Vec<S, 3>& x) {
  if (less_equal(cap.squared_cosine, S(S(1) / S(2))) == Verdict::holds) return {Vec<S, 3>::Constant(S(0)), squared_norm(x)};
  const Cap<S, 3> rotated{Vec<S, 3>::Constant(S(0)), rotate_by(cap.axis, x), fallback_height(cap)};
  return cap_ball_repaired(rotated);
}

// --- Hypotheses ---

template <class S>
Verdict cap_is_valid(const CapFallback<S>& cap) {
  const Verdict nothing_claimed = less_equal(cap.squared_cosine, S(S(1) / S(2)));
  return nothing_claimed |
         (less(S(0), squared_norm(cap.axis)) & less_equal(cap.squared_cosine, S(1)) & are_ahead<S>(cap.rotations, cap.axis) &
          are_within_cosine<S>(cap.rotations, cap.axis, cap.squared_cosine));
}

template <class S>
Verdict cap_fallback_hypotheses(const CapFallback<S>& cap, std::span<const S> u) {
  return cap_is_valid(cap) & is_convex(u) & less(S(0), squared_norm(combine<S, 4>(u, cap.rotations)));
}

// --- Conclusion ---

// The witness leads from a point of the hull of all r'_k + h R_c x to the vertex by two steps: that of the rotation, and y.
template <class S>
struct FallbackSteps {
  Verdict verdict;
  Vec<S, 3> vertex, hull_point, rotation_step;
};

// Checks the witness independently: the hull point has the coefficients u, and the rotation step goes from h R_c x to R_b x and
// is short enough.
template <class S>
Verdict is_fallback_steps(const CapFallback<S>& cap, const Vec<S, 3>& x, std::span<const S> u, const Vec<S, 3>& offset,
                          const FallbackSteps<S>& steps) {
  const SquaredBall<S, 3> ball = fallback_ball(cap, x);
  std::vector<Vec<S, 3>> centers;
  for (const auto& r : cap.center_images) centers.push_back(r + ball.center);
  const Vec<S, 3> rotated = ball.center + steps.rotation_step;
  Verdict v = is_hull_point<S, 3>(centers, steps.hull_point, u) & is_rotated<S>(combine<S, 4>(u, cap.rotations), x, rotated) &
              less_equal(squared_norm(steps.rotation_step), ball.squared_radius);
  for (int i = 0; i < 3; ++i) v &= equal(S(steps.hull_point[i] + steps.rotation_step[i] + offset[i]), steps.vertex[i]);
  return v;
}

template <class S>
FallbackSteps<S> cap_fallback_encloses(const CapFallback<S>& cap, const Vec<S, 3>& x, std::span<const S> u,
                                       const Vec<S, 3>& offset) {
  const SquaredBall<S, 3> ball = fallback_ball(cap, x);
  const Vec<S, 3> rotated = rotate_by<S>(combine<S, 4>(u, cap.rotations), x);
  const Vec<S, 3> linear = combine<S, 3>(u, cap.center_images);
  FallbackSteps<S> out{Verdict::undecided, rotated + linear + offset, linear + ball.center, rotated - ball.center};
  out.verdict = is_fallback_steps(cap, x, u, offset, out);
  return out;
}

// If no W_kl is negative, the cap about the sum of the weight vertices exists, because all of them are strictly ahead of it.
template <class S>
Verdict positive_pairs_are_ahead(const std::vector<Quaternion<S>>& rotations) {
  Verdict hypothesis = Verdict::holds, ahead = Verdict::holds;
  Quaternion<S> sum = Quaternion<S>::Constant(S(0));
  for (const auto& q : rotations) sum = sum + q;
  for (const auto& p : rotations) {
    hypothesis &= less(S(0), squared_norm(p));
    for (const auto& q : rotations) hypothesis &= less_equal(S(0), dot(p, q));
    ahead &= less(S(0), dot(p, sum));
  }
  return implies(hypothesis, ahead);
}

}  // namespace refitlab

// Sources: t3_one_cap, lemma5_cap_enclosing_sphere.
// Used by: b5_rotation_axis; algorithms/certificate/bound.cpp, experiments/drawings/control_hulls.cpp.
