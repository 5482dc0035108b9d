// SPDX-License-Identifier: MIT
// Beyond the paper: lines 11 to 15 of Algorithm 1 without a ball in R^4, for any angle and without losing digits.
//
// Statement. Let n_1 ... n_m be unit quaternions, let a be a unit quaternion, and let s^2 = max_k ||n_k - a||^2 / 4. If s^2
// < 1/2, let v = min(8 s^2 (1 - s^2), 1), else let v = 1. For every q != 0 that is a convex combination of the n_k, and for
// every x of R^3,
//   ||R_q x - (1 - v) R_a x|| <= sqrt(v (2 - v)) ||x||.
//
// Paper: section 4.3 and lines 11 to 15 of Algorithm 1. Their ball E is not needed: its cap is that of the farthest n_k.
// Notation: q''_k or n_k -> unit, a_C -> apex, 1 - v -> center_ratio, sqrt(v (2 - v)) -> radius_ratio.
//
// Proof. All n_k are in the cap of S_3 about a with the half chord s (t3_min_dot_distance). For s^2 < 1/2 this cap is less
// than half of S_3, so it holds the directions of all q (Lemma 4). Then the R_q x are in the cap of R^3 about R_a x of
// twice its angle, whose versine is 8 s^2 (1 - s^2) (s43_rotated_cap). The ball of Lemma 5, repaired, encloses that cap.
// For s^2 >= 1/2 the ball is that of the whole sphere.
#pragma once

#include <span>

#include "lemmas/lemma4_quaternion_hull.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/s43_rotated_cap.hpp"
#include "lemmas/vocabulary/nonzero.hpp"

namespace refitlab {

// For every non-zero q in the hull and every x, the image of x lies within radius_ratio ||x|| of center_ratio R(apex) x.
template <class S>
struct RotationBound {
  Quaternion<S> apex;  // unit
  S center_ratio;      // in [0, 1]
  S radius_ratio;      // in [0, 1]; the squares of both ratios sum to 1
};

// Returns no bound at all: it allows every rotation.
template <class S>
RotationBound<S> all_rotations() {
  return {identity_quaternion<S>(), S(0), S(1)};
}

// Returns the bound of the cap about the apex with s^2 < 1/2. Of s^2 = 1/2 it is all rotations.
template <class S>
RotationBound<S> bound_of_cap(const Quaternion<S>& apex, const S& squared_half_chord) {
  const CapBallRatios<S> ratios = cap_ball_ratios<S>(rotated_cap_versine(squared_half_chord));
  return {apex, ratios.center, root(ratios.squared_radius)};
}

// Returns s^2.
template <class S>
S squared_half_chord(std::span<const Quaternion<S>> unit, const Quaternion<S>& apex) {
  S farthest = squared_distance(unit[0], apex);
  for (const Quaternion<S>& q : unit.subspan(1)) farthest = max_of(farthest, squared_distance(q, apex));
  return farthest / S(4);
}

// unit has quaternions of unit length, and is not empty. direction should be in their middle, and has any length whose square is in
// the range of S. If the cap would be a
// half-sphere of S_3 or more, or if direction cannot be told from zero, the bound allows all rotations, as bound_of_cap does of a
// half-sphere. Packs take the same steps in each lane.
template <class S>
RotationBound<S> bound_rotations(std::span<const Quaternion<S>> unit, const Quaternion<S>& direction) {
  const S squared_length = squared_norm(direction), half_sphere = constant<S>(squared_half_chord_of_half_sphere);
  const auto is_nonzero = is_certainly_nonzero(squared_length);
  const Quaternion<S> apex = direction * (S(1) / root(choose(is_nonzero, squared_length, S(1))));
  const S s2 = squared_half_chord(unit, apex);
  const auto is_cap = is_nonzero && certainly_less(s2, half_sphere);
  return bound_of_cap<S>(choose(is_cap, apex, identity_quaternion<S>()), choose(is_cap, s2, half_sphere));
}

// Returns the ball that holds R_q x for every non-zero q in the hull. These are lines 14 and 15, without r'_k.
template <class S>
Ball3<S> rotated_ball(const RotationBound<S>& bound, const Vec<S, 3>& x) {
  return {rotate(bound.apex, x) * bound.center_ratio, bound.radius_ratio * norm(x)};
}

}  // namespace refitlab

// Sources: none.
// Used by: algorithms/runtime/batch/refit_kernel.cpp, algorithms/runtime/refit/algorithm1_repaired.hpp,
// algorithms/runtime/refit/control_hull.hpp, experiments/drawings/one_cap.cpp.
