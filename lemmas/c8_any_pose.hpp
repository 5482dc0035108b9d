// SPDX-License-Identifier: MIT
// Beyond the paper: where a vertex can be in any pose whatever, from bone lengths and the range of scales alone.
//
// Statement. Let the links of a chain carry y to t + R (s y) with any rotations R, ||t|| <= l and factors of the scale s of at
// most f. With d the length of a point x below the last link, and d -> f d + l for each link from the last to the first, the
// image of x is at most the last d from the origin of the first link's frame. The chain stretched out, at its greatest scales,
// reaches it.
// (i) Two joints that have the first links in common carry points no farther apart than the product of the common f times the
// sum of what the rest of both chains reaches.
// (ii) A vertex is in the ball about the origin with the greatest reach of its joints, by linear blending. By spherical
// blending about a fixed center r it is in that for r, blown up by ||v - r||. By dual quaternions, or spherically about a
// least-squares center, with rigid joints and all (q_k, q_l) >= 0, it is no farther than 3/4 A from the ball for v, with A^2 the
// sum of the squares of (i) over all pairs of joints at v (b7_motion_bound).
// Over an interval of a clip this bound needs no derivative, so it serves where a blend may vanish, or channels are not known.
//
// Replaces: nothing in the paper, which bounds one pose at a time.
// Notation: l -> length, f -> stretch, d -> distance.
//
// Proof. ||t + R (s y)|| <= l + f ||y||, link by link. (i) Seen from the frame where the chains part both points are within what
// the rest reaches of its origin, and the common links stretch a difference by at most the product of the f. (ii) A ball is
// convex; a rotation keeps ||v - r||; b7_motion_bound.
#pragma once

#include "lemmas/b7_motion_bound.hpp"
#include "lemmas/c2_channel_motion.hpp"

namespace refitlab {

// A LinkRange bounds one joint over all poses: the greatest length of its translation, and the greatest stretch of its scale.
template <class S>
struct LinkRange {
  S length, stretch;
};

// Returns the last d. The first link comes first.
template <class S>
S reach_of_chain(std::span<const LinkRange<S>> links, const S& distance) {
  S reach = distance;
  for (std::size_t k = links.size(); k-- > 0;) reach = links[k].stretch * reach + links[k].length;
  return reach;
}

// Returns the bound of (i) for the distance of two points. reach and other_reach are measured from where their chains part.
template <class S>
S apart_at_most(std::span<const LinkRange<S>> common, const S& reach, const S& other_reach) {
  S apart = reach + other_reach;
  for (const LinkRange<S>& link : common) apart = apart * link.stretch;
  return apart;
}

// Returns (3/4 A)^2. squared_spread is A^2.
template <class S>
S squared_deviation_in_any_pose(const S& squared_spread) {
  return squared_deviation_share(S(0)) * squared_spread;
}

// --- Hypotheses ---

// In a pose, a joint maps y -> translation + R (scale y).
template <class S>
struct PosedLink {
  Quaternion<S> rotation;
  Vec<S, 3> translation, scale;
};

template <class S>
Verdict is_in_range(const PosedLink<S>& link, const LinkRange<S>& range) {
  return equal(squared_norm(link.rotation), S(1)) & less_equal(S(0), range.length) &
         less_equal(squared_norm(link.translation), sq(range.length)) & less_equal(by_greatest_factor(link.scale), range.stretch);
}

// --- Conclusion ---

template <class S>
Vec<S, 3> posed(const PosedLink<S>& link, const Vec<S, 3>& y) {
  return rotate<S>(link.rotation, Vec<S, 3>(link.scale[0] * y[0], link.scale[1] * y[1], link.scale[2] * y[2])) + link.translation;
}

// The witness is the point, then its image by each link from the last to the first.
template <class S>
struct ReachSteps {
  Verdict verdict;
  std::vector<Vec<S, 3>> steps;
};

template <class S>
ReachSteps<S> stays_in_reach(std::span<const PosedLink<S>> links, std::span<const LinkRange<S>> ranges, const Vec<S, 3>& point,
                             const S& distance) {
  ReachSteps<S> out{Verdict::undecided, {point}};
  for (std::size_t k = links.size(); k-- > 0;) out.steps.push_back(posed(links[k], out.steps.back()));
  out.verdict = less_equal(squared_norm(out.steps.back()), sq(reach_of_chain(ranges, distance)));
  return out;
}

// Checks the witness independently, link by link: a step turned back is the step before it, scaled, and no step is longer than
// its reach.
template <class S>
Verdict are_reach_steps(std::span<const PosedLink<S>> links, std::span<const LinkRange<S>> ranges, const Vec<S, 3>& point,
                        const S& distance, std::span<const Vec<S, 3>> steps) {
  Verdict v = verdict_of(steps.size() == links.size() + 1) & less_equal(squared_norm(point), sq(distance));
  if (v != Verdict::holds) return v;
  for (int i = 0; i < 3; ++i) v &= equal(steps[0][i], point[i]);
  S reach = distance;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const std::size_t link = links.size() - 1 - k;
    const Vec<S, 3> back = rotate_scaled<S>(conjugate(links[link].rotation), steps[k + 1] - links[link].translation);
    for (int i = 0; i < 3; ++i) v &= equal(back[i], S(links[link].scale[i] * steps[k][i]));
    reach = ranges[link].length + ranges[link].stretch * reach;
    v &= less_equal(squared_norm(steps[k + 1]), sq(reach));
  }
  return v;
}

// Judges (i) for points below two chains that part after the common links.
template <class S>
Verdict stay_together(std::span<const PosedLink<S>> common, std::span<const LinkRange<S>> ranges, const Vec<S, 3>& a,
                      const Vec<S, 3>& b, const S& reach_of_a, const S& reach_of_b) {
  Vec<S, 3> x = a, y = b;
  for (std::size_t k = common.size(); k-- > 0;) x = posed(common[k], x), y = posed(common[k], y);
  return less_equal(squared_distance(x, y), sq(apart_at_most(ranges, reach_of_a, reach_of_b)));
}

// --- Erratum: the reference pose blown up ---

// Judges what engines without clips guess: no vertex reaches farther than in the reference pose, times a factor.
template <class S>
Verdict stays_in_guess(const Vec<S, 3>& reference, const Vec<S, 3>& posed, const S& factor) {
  return less_equal(squared_norm(posed), S(sq(factor) * squared_norm(reference)));
}

}  // namespace refitlab

// Sources: none.
// Used by: algorithms/bake/over_time/any_pose.cpp, experiments/drawings/motion.cpp.
