// SPDX-License-Identifier: MIT
// Lemma 1: the two definitions of a cap are the same.
//
// Statement. In R^d, d >= 1, let S be the surface with center c and radius r > 0.
// (i) -> (ii): Let H = {x : (x, d) >= D} with d != 0 meet S. Then the intersection of S and H is exactly the cap of S with
// apex a = c + s d and angle alpha, where s > 0, ||s d|| = r and cos alpha = max(-1, s (D - (c, d)) / r^2).
// (ii) -> (i): Let a be on S and cos alpha <= 1. Then H with d = a - c and D = r^2 cos alpha + (c, d) is a half-space,
// meets S, and intersects it in exactly the cap.
//
// Paper: section 4.3 (where alpha is in (0, pi)) and appendix, Lemma 1.
// Notation: c_s -> surface.center, r_s^2 -> surface.squared_radius, d -> half_space.normal, D -> half_space.offset,
// a_s -> cap.apex, cos(alpha_s) -> cap.cos_angle, "multiplied by a scalar" -> scale (s).
//
// Proof. For x on S, (x, d) >= D is equivalent to (x - c, s d) >= s (D - (c, d)). By Cauchy's inequality the left side is
// in [-r^2, r^2] and attains both ends. So S meets H if and only if s (D - (c, d)) <= r^2. If the right side is below -r^2,
// it may be raised to -r^2.
#pragma once

#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/root_comparison.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace refitlab {

// Returns D - (c, d), the offset of the half-space as seen from the center.
template <class S, int D>
S offset_from_center(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h) {
  return h.offset - dot(surface.center, h.normal);
}

// --- Hypotheses ---

// d != 0.
template <class S, int D>
Verdict is_half_space(const HalfSpace<S, D>& h) {
  return less(S(0), squared_norm(h.normal));
}

// The surface has a point in h, that is, D - (c, d) <= r ||d||.
template <class S, int D>
Verdict meets(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h) {
  return less_equal(S(0), surface.squared_radius) &
         at_most_root(offset_from_center(surface, h), S(surface.squared_radius * squared_norm(h.normal)));
}

// The hypotheses of (i): a proper half-space meets a proper surface.
template <class S, int D>
Verdict cuts_cap(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h) {
  return less(S(0), surface.squared_radius) & is_half_space(h) & meets(surface, h);
}

// s > 0 and ||s d|| = r.
template <class S, int D>
Verdict is_cap_scale(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h, const S& scale) {
  return less(S(0), scale) & equal(S(sq(scale) * squared_norm(h.normal)), surface.squared_radius);
}

// The hypotheses of (ii): the surface is proper, and the cosine is that of a cap that holds its apex.
template <class S, int D>
Verdict is_proper_cap(const Cap<S, D>& cap) {
  return less(S(0), squared_radius(cap)) & less_equal(cap.cos_angle, S(1));
}

// --- Conclusion ---

template <class S, int D>
struct CapOfHalfSpace {
  Verdict verdict;  // cos alpha is the cosine of an angle
  Cap<S, D> cap;
  S scale;  // s
};

// Computes (i) -> (ii) for a known scale, and so without a root. r > 0.
template <class S, int D>
CapOfHalfSpace<S, D> cap_of_half_space(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h, const S& scale) {
  const S cosine = scale * offset_from_center(surface, h) / surface.squared_radius;
  return {less_equal(cosine, S(1)), {surface.center, surface.center + h.normal * scale, max_of(cosine, S(-1))}, scale};
}

// Computes (i) -> (ii). It takes the root s = r / ||d||.
template <class S, int D>
CapOfHalfSpace<S, D> cap_of_half_space_by_root(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h) {
  return cap_of_half_space<S, D>(surface, h, root(S(surface.squared_radius / squared_norm(h.normal))));
}

template <class S, int D>
struct HalfSpaceOfCap {
  Verdict verdict;  // it is a half-space and meets the surface
  HalfSpace<S, D> half_space;
};

// Computes (ii) -> (i).
template <class S, int D>
HalfSpaceOfCap<S, D> half_space_of_cap(const Cap<S, D>& cap) {
  const Vec<S, D> normal = cap.apex - cap.center;
  const S r2 = squared_radius(cap);
  const HalfSpace<S, D> h{normal, S(r2 * cap.cos_angle) + dot(cap.center, normal)};
  return {is_half_space(h) & meets(SquaredBall<S, D>{cap.center, r2}, h), h};
}

// Judges the inequality of definition (ii) for a point of the surface.
template <class S, int D>
Verdict within_angle(const Cap<S, D>& cap, const Vec<S, D>& x) {
  const Vec<S, D> to_x = x - cap.center, to_apex = cap.apex - cap.center;
  return less_equal(S(squared_radius(cap) * cap.cos_angle), dot(to_x, to_apex));
}

// Definitions (i) and (ii) agree on the point x of the surface.
template <class S, int D>
Verdict definitions_agree(const HalfSpace<S, D>& h, const Cap<S, D>& cap, const Vec<S, D>& x) {
  const Verdict first = contains(h, x), second = within_angle(cap, x);
  return implies(first, second) & implies(second, first);
}

// Checks the witness independently, for all points at once: (x - c, a - c) - r^2 cos = s ((x, d) - D), or the cap is the
// whole surface.
template <class S, int D>
Verdict is_cap_of_half_space(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h, const CapOfHalfSpace<S, D>& witness) {
  const Cap<S, D>& cap = witness.cap;
  Verdict v = less(S(0), witness.scale) & equal(squared_radius(cap), surface.squared_radius) & less_equal(S(-1), cap.cos_angle) &
              less_equal(cap.cos_angle, S(1));
  for (int i = 0; i < D; ++i)
    v &= equal(cap.center[i], surface.center[i]) & equal(S(cap.apex[i] - cap.center[i]), S(h.normal[i] * witness.scale));
  const S reach = offset_from_center(surface, h) * witness.scale;
  const Verdict same = equal(S(surface.squared_radius * cap.cos_angle), reach);
  const Verdict whole = equal(cap.cos_angle, S(-1)) & less_equal(reach, S(-surface.squared_radius));
  return v & (same | whole);
}

template <class S, int D>
Verdict is_half_space_of_cap(const Cap<S, D>& cap, const HalfSpaceOfCap<S, D>& witness) {
  const HalfSpace<S, D>& h = witness.half_space;
  Verdict v = is_half_space(h) & contains(h, cap.apex) &
              equal(S(h.offset - dot(cap.center, h.normal)), S(squared_radius(cap) * cap.cos_angle));
  for (int i = 0; i < D; ++i) v &= equal(h.normal[i], S(cap.apex[i] - cap.center[i]));
  return v;
}

template <class S, int D>
Verdict half_space_is_cap_repaired(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h, const S& scale,
                                   const Vec<S, D>& x) {
  const Verdict hypotheses = cuts_cap(surface, h) & is_cap_scale(surface, h, scale) & on_surface(surface, x);
  if (hypotheses == Verdict::fails) return Verdict::holds;  // there may be no cap to build
  const auto made = cap_of_half_space(surface, h, scale);
  return implies(hypotheses, made.verdict & definitions_agree(h, made.cap, x));
}

template <class S, int D>
Verdict cap_is_half_space_repaired(const Cap<S, D>& cap, const Vec<S, D>& x) {
  const auto made = half_space_of_cap(cap);
  return implies(is_proper_cap(cap) & on_surface(SquaredBall<S, D>{cap.center, squared_radius(cap)}, x),
                 made.verdict & definitions_agree(made.half_space, cap, x));
}

// --- Erratum ---
// "Some d in R^d" may be 0, and no scalar stretches 0 to r_s. "Any non-zero scalar" may be negative, and a negative scalar
// turns the half-space into its opposite. If a half-space holds the whole surface, its plane can be arbitrarily far from
// the center. Then |D - (c_s, d)| <= r_s^2 fails, and no angle has the cosine that the proof asks for.

// Printed: For every half-space that meets the surface, a non-zero scalar k with ||k d|| = r exists. For every
// such k, |k D - (c, k d)| <= r^2, and the cap with apex c + k d and cosine (k D - (c, k d)) / r^2 is the same
// set.
template <class S, int D>
Verdict half_space_is_cap_printed(const SquaredBall<S, D>& surface, const HalfSpace<S, D>& h, const S& scalar,
                                  const Vec<S, D>& x) {
  const S r2 = surface.squared_radius, reach = scalar * offset_from_center(surface, h);
  const Verdict stretches = equal(S(sq(scalar) * squared_norm(h.normal)), r2) & !equal(scalar, S(0));
  const Verdict has_angle = less_equal(S(-r2), reach) & less_equal(reach, r2);
  const Vec<S, D> axis = h.normal * scalar, to_x = x - surface.center;
  const Verdict first = contains(h, x), second = less_equal(reach, dot(to_x, axis));
  return implies(meets(surface, h) & on_surface(surface, x),
                 stretches & has_angle & implies(first, second) & implies(second, first));
}

}  // namespace refitlab

// Sources: the paper; Cauchy's inequality.
// Used by: lemma3_sphere_surface_intersection; experiments/drawings/common.hpp, experiments/drawings/lemmas.cpp,
// experiments/explorer/pages/lemma1.hpp, experiments/explorer/pages/lemma3.hpp, experiments/pictures/cap_figure.cpp.
