// SPDX-License-Identifier: MIT
// Lemma 4 and Corollary 1: a ball around unit vectors bounds the directions of all of their blends.
//
// Statement. In R^d, d >= 1, let n_1 ... n_m be unit vectors in the ball E = [c, r]. Let C be the intersection of E with
// the unit sphere's surface, and let o = 1 + ||c||^2 - r^2. Then {x : (x, 2c) >= o} cuts out C (Lemma 3). Let b = sum w_i
// n_i with w in W_m.
// Lemma 4: If o >= 0, or if E holds the whole surface, b / ||b|| is in C for every b != 0. If o > 0, no b is 0, and c != 0.
// For d >= 2, every other ball fails for some n_i and w.
// Corollary 1: For every b != 0, b / ||b|| or its negative is in C. So each rotation of the hull is in C, for any ball E
// that holds the n_i. The corollary needs no condition on the radius.
//
// Paper: appendix, Lemma 4 and Corollary 1, for d = 4 and r < 1; used in section 4.3 and lines 11-13 of Algorithm 1.
// Notation: n_i -> units[i], E -> ball, w -> weights, n' (b) -> blend, o -> scaled_distance = 2 ||c|| d_H.
//
// Proof. ||n_i - c||^2 <= r^2 is equivalent to 2 (n_i, c) >= o, so 2 (b, c) >= o. If o >= 0, ||b|| <= 1 gives 2 (b, c) >= o
// ||b||. If o > 0, then (b, c) is not 0, so b and c are not 0. If o <= 0, one of b and -b has 2 (+-b, c) >= 0 >= o ||b||.
// Conversely, let -2 ||c|| < o < 0. Then the rim of C has two points whose midpoint is a negative multiple of c, but -c /
// ||c|| is not in C. Finally, c = 0 gives o = 1 - r^2 <= 0.
#pragma once

#include "lemmas/lemma2_normalization.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/vocabulary/root_comparison.hpp"

namespace refitlab {

// --- Hypotheses ---

template <class S, int D>
Verdict are_units_enclosed(const SquaredBall<S, D>& ball, const VecList<S, D>& units) {
  Verdict v = verdict_of(!units.empty());
  for (const auto& n : units) v &= equal(squared_norm(n), S(1)) & encloses(ball, n);
  return v;
}

// r^2 <= 1 + ||c||^2, or r >= 1 + ||c||. These are exactly the balls that bound every hull.
template <class S, int D>
Verdict ball_keeps_hulls(const SquaredBall<S, D>& ball) {
  const S o = scaled_distance(ball.center, ball.squared_radius);
  return less_equal(S(0), o) | multiple_of_root_at_most(S(2), squared_norm(ball.center), S(-o));
}

// A cap about a unit vector, whose squared half chord s^2 is less than this, is less than half of the surface. It is C of the
// ball about that vector with the radius 2 s, for which o = 2 - 4 s^2 > 0.
inline constexpr double squared_half_chord_of_half_sphere = 0.5;

// --- Conclusion ---

// b / ||b|| is in E, for b != 0. This is o ||b|| <= 2 (b, c).
template <class S, int D>
Verdict direction_is_enclosed(const SquaredBall<S, D>& ball, const Vec<S, D>& b) {
  return multiple_of_root_at_most(scaled_distance(ball.center, ball.squared_radius), squared_norm(b),
                                  S(S(2) * dot(b, ball.center)));
}

// Returns b / ||b||. It takes a root. b != 0.
template <class S, int D>
Vec<S, D> direction_by_root(const Vec<S, D>& b) {
  return b / norm(b);
}

template <class S, int D>
struct HullElement {
  Verdict verdict;  // the direction of the blend (Lemma 4) or the blend's rotation (Corollary 1) is in E
  Vec<S, D> blend;  // b
  S along;          // (b, c), at least o / 2
};

template <class S, int D>
HullElement<S, D> hull_element(const SquaredBall<S, D>& ball, const VecList<S, D>& units, const std::vector<S>& weights) {
  const Vec<S, D> b = combine<S, D>(weights, units);
  return {direction_is_enclosed(ball, b), b, dot(b, ball.center)};
}

// Checks the witness independently, with no direction and no squares of products. It checks (b, c) >= o / 2 and ||b|| <= 1.
// For o >= 0 this gives (b, c) >= (o / 2) ||b||.
template <class S, int D>
Verdict is_hull_element(const SquaredBall<S, D>& ball, const VecList<S, D>& units, const std::vector<S>& weights,
                        const HullElement<S, D>& witness) {
  const S o = scaled_distance(ball.center, ball.squared_radius);
  Verdict v = ball_keeps_hulls(ball) & less_equal(squared_norm(witness.blend), S(1)) &
              equal(dot(witness.blend, ball.center), witness.along) & less_equal(o, S(S(2) * witness.along));
  for (int i = 0; i < D; ++i) {
    S sum(0);
    for (std::size_t k = 0; k < units.size(); ++k) sum = sum + weights[k] * units[k][i];
    v &= equal(sum, witness.blend[i]);
  }
  return v;
}

template <class S, int D>
Verdict hull_stays_in_cap_repaired(const SquaredBall<S, D>& ball, const VecList<S, D>& units, const std::vector<S>& weights) {
  const auto made = hull_element(ball, units, weights);
  const Verdict is_direction = less(S(0), squared_norm(made.blend));
  return implies(
      are_units_enclosed(ball, units) & is_convex<S>(weights) & ball_keeps_hulls(ball),
      implies(less(S(0), scaled_distance(ball.center, ball.squared_radius)), is_direction) & implies(is_direction, made.verdict));
}

// --- Corollary 1 ---

// The rotation of b != 0 is in C, as b / ||b|| or as -b / ||b||.
template <class S, int D>
Verdict rotation_is_enclosed(const SquaredBall<S, D>& ball, const Vec<S, D>& b) {
  const Vec<S, D> opposite = -b;
  return direction_is_enclosed(ball, b) | direction_is_enclosed(ball, opposite);
}

template <class S, int D>
Verdict rotations_stay_in_cap_repaired(const SquaredBall<S, D>& ball, const VecList<S, D>& units, const std::vector<S>& weights) {
  const Vec<S, D> b = combine<S, D>(weights, units);
  return implies(are_units_enclosed(ball, units) & is_convex<S>(weights) & less(S(0), squared_norm(b)),
                 rotation_is_enclosed(ball, b));
}

// --- Erratum: the radius need not be below 1 ---
// r < 1 is sufficient, because it makes o > 0. It is not necessary: a mean ball of quaternions with r >= 1 may make a good
// cap.

template <class S, int D>
Verdict hull_hypotheses_printed(const SquaredBall<S, D>& ball, const VecList<S, D>& units, const std::vector<S>& weights) {
  return are_units_enclosed(ball, units) & is_convex<S>(weights) & less(ball.squared_radius, S(1));
}

// Printed: Lemma 4.
template <class S, int D>
Verdict hull_stays_in_cap_printed(const SquaredBall<S, D>& ball, const VecList<S, D>& units, const std::vector<S>& weights) {
  const auto made = hull_element(ball, units, weights);
  return implies(hull_hypotheses_printed(ball, units, weights), less(S(0), squared_norm(made.blend)) & made.verdict);
}

// Printed: Corollary 1.
template <class S, int D>
Verdict rotations_stay_in_cap_printed(const SquaredBall<S, D>& ball, const VecList<S, D>& units, const std::vector<S>& weights) {
  const Vec<S, D> b = combine<S, D>(weights, units);
  return implies(hull_hypotheses_printed(ball, units, weights), less(S(0), squared_norm(b)) & rotation_is_enclosed(ball, b));
}

// The fallback of section 4.3 to the whole of S_3 assumes this: no ball with a radius of 1 or more bounds hulls.
template <class S, int D>
Verdict radius_below_one_is_needed_printed(const SquaredBall<S, D>& ball) {
  return implies(ball_keeps_hulls(ball), less(ball.squared_radius, S(1)));
}

}  // namespace refitlab

// Sources: the paper.
// Used by: rotation_bound; algorithms/methods/refit/algorithm1_printed.hpp, experiments/drawings/common.hpp,
// experiments/explorer/pages/lemma4.hpp.
