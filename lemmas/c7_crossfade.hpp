// SPDX-License-Identifier: MIT
// Beyond the paper: how a joint moves in a crossfade of two clips, in each of their times and in the weight.
//
// Statement. Let the weight w in [w_0, w_1], 0 <= w_0 and w_1 <= 1, fade from a clip at the time a to another at b, with
// channels that move within A and B. In each of the three parameters alone, the others being held,
// (i) translations and scales (1 - w) x + w y have the size max(A, B), and move in a by 1 - w_0 times A, in b by w_1 times B,
//   and in w at the speed g and without bending, g >= ||y - x||.
// (ii) Rotations blended by nlerp, (1 - w) p + w q normalised, for unit p and q with (p, q) >= c > -1: their blend moves by (i)
//   with g = sqrt(2 - 2 c) and is at least sqrt((1 + c) / 2) long, so that c3_normalized_motion bounds it.
// (iii) Rotations blended by slerp, for (p, q) >= c >= 0, move in w within 1, theta, theta^2 for theta = arccos c. In a, let p
//   move within 1, L, M, let m = 1 - w be at most the share, and m w at most P. Then they move at a speed of at most U L, with
//   U = min(1, m (1 + (pi/2 - 1) (1 - c))), and bend by at most (U + P (c + pi (1 - c))) M + P (4 c / 3 + pi (1 - c)) s L^2 +
//   3 P (4 c / 15 + pi/2 (1 - c)) s^2 L^2, with s = sqrt(1 - c^2). The same is true in b, with w in place of m.
// (iv) Rotations blended by slerp, for (p, q) >= -1/2, move in w as (iii) says, and in a or b at a speed of at most 2 L / sqrt 3.
// Engines take q or -q, the one with (p, q) >= 0. Where that sign is not the same for all times, both are bounded, each also at
// times at which engines take the other one, with a c that is a little below 0: the joint is in one of both bounds. With these
// links c4_chain_motion gives a point's motion in each parameter, and c6_interval_hull the slack of a box of times and weights
// from its eight corners. A point that is held by both clips' bounds may leave their hull in between.
//
// Replaces: nothing in the paper. Engines take bounds of both clips, or of the reference pose, blown up by a guess.
// Notation: p, q -> first, second; c -> cosine, g -> gap, 1 - w_0 or w_1 -> share.
//
// Proof. (i) and the length in (ii) by a look: ||(1 - w) p + w q||^2 is least at halves, or greater. (iii) In w it is a circle's
// arc. In a, slerp is s = u(k) p + v(k) q for k = (p, q), with u = sin(m t) / sin t, m = 1 - w, t = arccos k, and v the same for
// w. u = m F(1 - m, 1 + m; 3/2; (1 - k) / 2), a series without negative coefficients, so u, |u'| and u'' are convex in k and at
// most what is linear between their values at 0, sin(m pi/2), m cos(m pi/2), (1 - m^2) sin(m pi/2), and at 1, m, m (1 - m^2) / 3,
// m (1 - m^2) (4 - m^2) / 15. With sin x <= x and cos(m pi/2) <= pi/2 w: u <= U; 2 |u'|, |u'| + |v'| and u'' + v'' are at most P
// times the factors above, since m + w = 1. Moved along the arc, p moves s by m; across, by u: ||s'|| <= U L. |k'| <= s L, as p'
// is perpendicular to p, and |k''| <= M, so ||s''|| <= u M + (|u'| + |v'|) M + 2 |u'| |k'| L + (u'' + v'') k'^2. (iv) For t <=
// pi/2 u <= 1; beyond, u <= 1 / sin t <= 2 / sqrt 3, since t <= 2 pi/3.
#pragma once

#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/c2_channel_motion.hpp"
#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/c6_interval_hull.hpp"

namespace refitlab {

// Returns the motion of (i) in a, where the share is 1 - w_0, or in b, where it is w_1. The other clip is held.
template <class S>
Motion<S> faded_by_time(const Motion<S>& moving, const S& size_of_other, const S& share) {
  return {max_of(moving.size, size_of_other), share * moving.speed, share * moving.acceleration};
}

// Returns the motion of (i) in w.
template <class S>
Motion<S> faded_by_weight(const S& size, const S& size_of_other, const S& gap) {
  return {max_of(size, size_of_other), gap, S(0)};
}

// These return g and the least length of (ii).
template <class S>
S gap_of_units(const S& cosine) {
  return root(S(S(2) - S(2) * cosine));
}
template <class S>
S least_half_way(const S& cosine) {
  return root(S((S(1) + cosine) / S(2)));
}

// Returns the motion of the normalised blend by (ii). blend is the motion of the blend itself.
template <class S>
Motion<S> nlerp_motion(const Motion<S>& blend, const S& cosine) {
  return normalized_motion(blend, least_half_way(cosine));
}

// Returns the motion of (iii) in w.
template <class S>
Motion<S> slerp_by_weight(const S& cosine) {
  return circle_motion<S>(angle_by_half_tangent<S>(root(S((S(1) - cosine) / (S(1) + cosine)))));
}

// Returns the motion of (iii) in a, where the share is the greatest 1 - w, or in b, where it is the greatest w. product is P.
template <class S>
Motion<S> slerp_by_time(const Motion<S>& moving, const S& cosine, const S& share, const S& product) {
  const S pi = S(22) / S(7), left = S(1) - cosine;
  const S most = min_of(S(1), S(share * (S(1) + (pi / S(2) - S(1)) * left)));
  const S sine = root(S(S(1) - sq(cosine))), bend = sine * sq(moving.speed);
  return {S(1), most * moving.speed,
          (most + product * (cosine + pi * left)) * moving.acceleration +
              product * bend * (S(4) / S(3) * cosine + pi * left + S(3) * sine * (S(4) / S(15) * cosine + pi / S(2) * left))};
}

// Returns the speed of (iv) in a or b.
template <class S>
S slerp_speed_beyond(const S& speed) {
  return S(2) * speed / root(S(3));
}

// --- Hypotheses ---

template <class S>
Verdict crossfade_hypotheses(const Quaternion<S>& first, const Quaternion<S>& second, const S& cosine, const S& weight) {
  return equal(squared_norm(first), S(1)) & equal(squared_norm(second), S(1)) & less(S(-1), cosine) &
         less_equal(cosine, dot(first, second)) & is_share(weight);
}

// A slerp also needs this: the cosine is not negative.
template <class S>
Verdict is_shorter_way(const S& cosine) {
  return less_equal(S(0), cosine);
}

// (iv) also needs this: the cosine is at least -1/2.
template <class S>
Verdict is_hardly_the_longer_way(const S& cosine) {
  return less_equal(S(S(-1) / S(2)), cosine);
}

// --- Conclusion ---

// These return the moment of (1 - w) x + w y as x moves, as y moves, and as w does.
template <class S, int D>
Moment<S, D> fading_first(const Moment<S, D>& x, const Vec<S, D>& y, const S& weight) {
  const S left = S(1) - weight;
  return {between<S, D>(x.value, y, weight), x.velocity * left, x.acceleration * left};
}
template <class S, int D>
Moment<S, D> fading_second(const Vec<S, D>& x, const Moment<S, D>& y, const S& weight) {
  return fading_first<S, D>(y, x, S(S(1) - weight));
}
template <class S, int D>
Moment<S, D> fading_weight(const Vec<S, D>& x, const Vec<S, D>& y, const S& weight) {
  return {between<S, D>(x, y, weight), y - x, Vec<S, D>::Constant(S(0))};
}

// The blend is at least as long as (ii) says.
template <class S>
Verdict is_long_blend(const Quaternion<S>& blend, const S& cosine) {
  return less_equal(S(S(1) + cosine), S(S(2) * squared_norm(blend)));
}

// Judges (ii) for a blend that moves within the bounds. The witness is that of c3_normalized_motion.
template <class S>
Verdict nlerp_moves(const Moment<S, 4>& blend, const Motion<S>& motion, const S& cosine) {
  return is_long_blend(blend.value, cosine) & normalized_moves(blend, motion, least_half_way(cosine)).verdict;
}

// Checks a moment of a slerp independently: it stays of length 1 and within the bounds.
template <class S>
Verdict is_slerp_moment(const Moment<S, 4>& moment, const Motion<S>& motion) {
  return equal(squared_norm(moment.value), S(1)) & equal(dot(moment.value, moment.velocity), S(0)) &
         equal(S(dot(moment.value, moment.acceleration) + squared_norm(moment.velocity)), S(0)) & moves_within(moment, motion);
}

// --- Erratum: the clips' own bounds ---

// Judges whether a slab that holds a point in both clips also holds it in between.
template <class S>
Verdict stays_in_slab_of_clips(const Slab<S>& first, const Slab<S>& second, const Vec<S, 3>& direction, const Vec<S, 3>& x) {
  return in_slab(slab_of_keys(first, second), direction, x);
}

}  // namespace refitlab

// Sources: none.
// Used by: algorithms/bake/over_time/crossfaded_joints.cpp, experiments/drawings/motion.cpp.
