// SPDX-License-Identifier: MIT
// Beyond the paper: how a joint moves in a crossfade of two clips, in each of their times and in the weight.
//
// Statement. Let the weight w in [w_0, w_1], 0 <= w_0 and w_1 <= 1, fade from a clip at the time a to another at b, with
// channels that move within A and B. In each of the three parameters alone, the others being held,
// (i) translations and scales (1 - w) x + w y have the size max(A, B), and move in a by 1 - w_0 times A, in b by w_1 times B,
//   and in w at the speed g and without bending, g >= ||y - x||.
// (ii) Rotations blended by nlerp, (1 - w) p + w q normalised, for unit p and q with (p, q) >= c > -1: their blend moves by (i)
//   with g = sqrt(2 - 2 c) and is at least sqrt((1 + c) / 2) long, so what is said of normalised blends is said of it.
// (iii) By slerp, for (p, q) >= c >= 0: in w within 1, theta, theta^2 for theta = arccos c; in a within 1, L, 2 (M + L^2), for p
//   within 1, L, M; and so in b.
// Engines take q or -q, the one with (p, q) >= 0. Where that sign is not the same for all times, both are bounded: the
// joint is in one of both bounds. With these links c4_chain_motion gives a point's motion in each parameter, and
// c6_interval_hull the slack of a box of times and weights from its eight corners. A point that is held by both clips' bounds
// may leave their hull in between.
//
// Replaces: nothing in the paper. Engines take bounds of both clips, or of the reference pose, blown up by a guess.
// Notation: p, q -> first, second; c -> cosine, g -> gap, 1 - w_0 or w_1 -> share.
//
// Proof. (i) and the length in (ii) by a look: ||(1 - w) p + w q||^2 is least at halves, or greater. (iii) In w it is a circle's
// arc. In a, slerp is s = u(k) p + v(k) q for k = (p, q), with u = sin(m t) / sin t, m = 1 - w, t = arccos k, and v the same for
// m = w. As a hypergeometric function of (1 - k) / 2, u has no negative coefficient (m <= 1), so |u'| and u'' are greatest at k = 0:
// m cos(m pi/2) and (1 - m^2) sin(m pi/2). Moved along the arc, p moves s by m; across, by u <= 1: ||ds/da|| <= L. And ||s''|| <=
// u M + 2 |u'| L^2 + (u'' + v'') L^2 + (|u'| + |v'|) M, where u <= 1 and |u'| + |v'| <= m + w = 1, and with cos x <= pi/2 - x and sin x
// <= x the rest is at most (pi m w + 3 pi/2 m w) L^2 <= 5 pi/8 L^2 < 2 L^2.
#pragma once

#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/c4_chain_motion.hpp"
#include "lemmas/c6_interval_hull.hpp"

namespace refitlab {

// (i) in a, where the share is 1 - w_0; or in b, where it is w_1. The other clip is held.
template <class S>
Motion<S> faded_by_time(const Motion<S>& moving, const S& size_of_other, const S& share) {
  return {max_of(moving.size, size_of_other), share * moving.speed, share * moving.acceleration};
}

// (i) in w.
template <class S>
Motion<S> faded_by_weight(const S& size, const S& size_of_other, const S& gap) {
  return {max_of(size, size_of_other), gap, S(0)};
}

// g and the least length of (ii).
template <class S>
S gap_of_units(const S& cosine) {
  return root(S(S(2) - S(2) * cosine));
}
template <class S>
S least_half_way(const S& cosine) {
  return root(S((S(1) + cosine) / S(2)));
}

// (ii): of the normalised blend, by the motion of the blend.
template <class S>
Motion<S> nlerp_motion(const Motion<S>& blend, const S& cosine) {
  return normalized_motion(blend, least_half_way(cosine));
}

// (iii) in w.
template <class S>
Motion<S> slerp_by_weight(const S& cosine) {
  return circle_motion<S>(angle_by_half_tangent<S>(root(S((S(1) - cosine) / (S(1) + cosine)))));
}

// (iii) in a or b.
template <class S>
Motion<S> slerp_by_time(const Motion<S>& moving) {
  return {S(1), moving.speed, S(2) * (moving.acceleration + sq(moving.speed))};
}

// --- Hypotheses ---

template <class S>
Verdict crossfade_hypotheses(const Quaternion<S>& first, const Quaternion<S>& second, const S& cosine, const S& weight) {
  return equal(squared_norm(first), S(1)) & equal(squared_norm(second), S(1)) & less(S(-1), cosine) &
         less_equal(cosine, dot(first, second)) & is_share(weight);
}

// Of a slerp, besides.
template <class S>
Verdict is_shorter_way(const S& cosine) {
  return less_equal(S(0), cosine);
}

// --- Conclusion ---

// (1 - w) x + w y as x moves, as y moves, and as w does.
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

// The blend is as long as said.
template <class S>
Verdict is_long_blend(const Quaternion<S>& blend, const S& cosine) {
  return less_equal(S(S(1) + cosine), S(S(2) * squared_norm(blend)));
}

// (ii) of a blend that moves within the bounds: its witness is that of c3_normalized_motion.
template <class S>
Verdict nlerp_moves(const Moment<S, 4>& blend, const Motion<S>& motion, const S& cosine) {
  return is_long_blend(blend.value, cosine) & normalized_moves(blend, motion, least_half_way(cosine)).verdict;
}

// Independent check of a moment of a slerp: it stays of length 1, and within the bounds.
template <class S>
Verdict is_slerp_moment(const Moment<S, 4>& moment, const Motion<S>& motion) {
  return equal(squared_norm(moment.value), S(1)) & equal(dot(moment.value, moment.velocity), S(0)) &
         equal(S(dot(moment.value, moment.acceleration) + squared_norm(moment.velocity)), S(0)) & moves_within(moment, motion);
}

// --- Erratum: the clips' own bounds ---

// A slab that holds a point in both clips, for all that is between.
template <class S>
Verdict stays_in_slab_of_clips(const Slab<S>& first, const Slab<S>& second, const Vec<S, 3>& direction, const Vec<S, 3>& x) {
  return in_slab(slab_of_keys(first, second), direction, x);
}

}  // namespace refitlab

// Sources: none.
// Used by: experiments/drawings/motion.cpp.
