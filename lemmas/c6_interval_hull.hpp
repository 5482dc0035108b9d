// SPDX-License-Identifier: MIT
// Beyond the paper: bounds that hold throughout an interval, from bounds at its ends.
//
// Statement. (i) Let points move over an interval of the length h with ||f''|| <= M each, or ||f'|| <= L, and let a convex set
// K hold all of them at both ends. With the slack e = min(M h^2 / 8, L h / 2), K blown up by e in all directions holds them
// throughout: a ball's radius grows by e, a slab {x : low <= (n, x) <= high} by ||n|| e on both sides, and so do the boxes and
// k-DOPs that are intersections of slabs. Half of the interval has at most half of
// the slack, and a quarter where that is M h^2 / 8.
// (ii) Let f depend on p parameters in a box with sides h_i, with such bounds M_i or L_i of the derivatives in each of them
// alone, the others being held. A convex set that holds f at all 2^p corners holds it throughout if it is blown up by the sum
// of the e_i. Nothing is asked of mixed derivatives.
// (iii) A number that is at least c at both ends is at least c - e in between: so are the cosines of quaternions, whose dot
// product moves within the product of their bounds.
// Intervals end where a channel jumps, or bends without a bound: at keys. There, both sides of the key are bounded.
//
// Replaces: nothing in the paper. Engines take K itself, at keys or at a fixed rate: points leave it in between.
// Notation: e -> slack, n -> direction, h -> duration or sides, shares of the sides -> shares.
//
// Proof. (i) Each point is within e of its chord (c1_chord_bound), which is in K. (ii) Interpolating linearly between two sides
// of the box does not lengthen a vector, so f minus its interpolation by all parameters is at most the sum of what each adds;
// the interpolation by all of them is a convex combination of the corners. (iii) is (i) in R^1.
#pragma once

#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/vocabulary/slab.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns the most that a convex function reaches throughout, from the most that it reaches at the ends, or corners. Over each
// distance it changes by no more than the scale times that. The scale of (n, x) is ||n||, and that of the distance from a
// point is 1.
template <class S>
S greatest_over_interval(const S& at_ends, const S& scale, const S& slack) {
  return at_ends + scale * slack;
}

// Returns the slab of the interval. start and end are the slabs of its ends.
template <class S>
Slab<S> interval_slab(const Slab<S>& start, const Slab<S>& end, const S& slack, const S& direction_length) {
  const S most_downward = greatest_over_interval(S(-min_of(start.low, end.low)), direction_length, slack);
  return {-most_downward, greatest_over_interval(max_of(start.high, end.high), direction_length, slack)};
}

// Returns the ball of the interval. around_both encloses the balls of both ends.
template <class S>
Ball3<S> interval_ball(const Ball3<S>& around_both, const S& slack) {
  return {around_both.center, greatest_over_interval(around_both.radius, S(1), slack)};
}

// Returns the sum of the e_i of (ii).
template <class S>
S box_slack(std::span<const S> slacks) {
  S sum(0);
  for (const S& slack : slacks) sum = sum + slack;
  return sum;
}
template <class S>
S box_slack(std::span<const Motion<S>> motions, std::span<const S> sides) {
  std::vector<S> slacks;
  for (std::size_t i = 0; i < sides.size(); ++i) slacks.push_back(chord_slack(motions[i], sides[i]));
  return box_slack<S>(slacks);
}

// Returns the least value of (iii).
template <class S>
S least_over_interval(const S& start, const S& end, const S& slack) {
  return min_of(start, end) - slack;
}

// (ii) is executed on a function of p parameters, which are shares of the sides of a box. The function is given by its values at
// the corners, the first parameter's ends next to each other. For each parameter it has the corners of the second derivative,
// which does not depend on that parameter.
template <class S>
struct BentPatch {
  std::vector<Vec<S, 3>> corners;             // 2^p
  std::vector<std::vector<Vec<S, 3>>> bends;  // p times 2^p; ends of the parameter itself are the same
  std::vector<S> sides;

  static Vec<S, 3> interpolated(std::vector<Vec<S, 3>> corners, std::span<const S> shares) {
    for (const S& share : shares) {
      for (std::size_t k = 0; 2 * k < corners.size(); ++k) corners[k] = between<S, 3>(corners[2 * k], corners[2 * k + 1], share);
      corners.resize(corners.size() / 2);
    }
    return corners[0];
  }
  Vec<S, 3> at(std::span<const S> shares) const {
    Vec<S, 3> f = interpolated(corners, shares);
    for (std::size_t i = 0; i < sides.size(); ++i)
      f = f - interpolated(bends[i], shares) * S(sq(sides[i]) * shares[i] * (S(1) - shares[i]) / S(2));
    return f;
  }
};

// --- Hypotheses ---

template <class S>
Verdict in_slab(const Slab<S>& slab, const Vec<S, 3>& direction, const Vec<S, 3>& x) {
  const S along = dot(direction, x);
  return less_equal(slab.low, along) & less_equal(along, slab.high);
}

// Judges the hypotheses of (i), for a slab and for a ball.
template <class S>
Verdict interval_hypotheses(std::span<const CubicCurve<S, 3>> curves, const S& acceleration, const Slab<S>& start,
                            const Slab<S>& end, const Vec<S, 3>& direction, const Ball3<S>& around_both, const S& share) {
  Verdict v = is_share(share);
  for (const auto& curve : curves)
    v &= less(S(0), curve.duration) & bends_within(curve, acceleration) & in_slab(start, direction, curve.points[0]) &
         in_slab(end, direction, curve.points[3]) & encloses(around_both, curve.points[0]) &
         encloses(around_both, curve.points[3]);
  return v;
}

// Judges the hypotheses of (ii).
template <class S>
Verdict patch_hypotheses(const BentPatch<S>& patch, std::span<const Motion<S>> motions, std::span<const S> shares) {
  Verdict v = Verdict::holds;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    v &= is_share(shares[i]) & is_motion(motions[i]) & less_equal(S(0), patch.sides[i]);
    for (const auto& bend : patch.bends[i]) v &= less_equal(squared_norm(bend), sq(motions[i].acceleration));
  }
  return v;
}

// --- Conclusion ---

// Judges (i): every curve at the share is in the slab and in the ball of the interval. The slack is that of M.
template <class S>
Verdict stays_in_interval(std::span<const CubicCurve<S, 3>> curves, const S& acceleration, const Slab<S>& start,
                          const Slab<S>& end, const Vec<S, 3>& direction, const S& direction_length, const Ball3<S>& around_both,
                          const S& share) {
  Verdict v = Verdict::holds;
  for (const auto& curve : curves) {
    const S slack = chord_slack(acceleration, curve.duration);
    const Vec<S, 3> at = curve.at(share);
    v &= in_slab(interval_slab(start, end, slack, direction_length), direction, at) &
         encloses(interval_ball(around_both, slack), at);
  }
  return v;
}

// The witness of (ii) is a point of the hull of the corners and its weights.
template <class S>
struct HullPoint {
  Verdict verdict;
  std::vector<S> weights;
  Vec<S, 3> in_hull;
};

// Checks the witness independently: the weights are convex and lead to the point, and f is no farther than the slack.
template <class S>
Verdict is_near_hull(const BentPatch<S>& patch, std::span<const Motion<S>> motions, std::span<const S> shares,
                     const HullPoint<S>& witness) {
  const Vec<S, 3> there = combine<S, 3>(witness.weights, patch.corners);
  Verdict v = is_convex<S>(witness.weights);
  for (int i = 0; i < 3; ++i) v &= equal(there[i], witness.in_hull[i]);
  S allowed(0);
  for (std::size_t i = 0; i < shares.size(); ++i) allowed = allowed + motions[i].acceleration * sq(patch.sides[i]) / S(8);
  return v & less_equal(squared_distance(patch.at(shares), witness.in_hull), sq(allowed));
}

// Computes the witness from the accelerations alone. The speeds count as unknown.
template <class S>
HullPoint<S> point_near_hull(const BentPatch<S>& patch, std::span<const Motion<S>> motions, std::span<const S> shares) {
  HullPoint<S> out{Verdict::undecided, {S(1)}, patch.corners[0]};
  for (const S& share : shares) {
    const std::size_t count = out.weights.size();
    for (std::size_t k = 0; k < count; ++k) out.weights.push_back(out.weights[k] * share);
    for (std::size_t k = 0; k < count; ++k) out.weights[k] = out.weights[k] * (S(1) - share);
  }
  out.in_hull = combine<S, 3>(out.weights, patch.corners);
  out.verdict = is_near_hull(patch, motions, shares, out);
  return out;
}

// --- Erratum: the hull of the ends ---

// Returns what engines take for an interval: the box around both ends, without a slack.
template <class S>
Slab<S> slab_of_keys(const Slab<S>& start, const Slab<S>& end) {
  return interval_slab(start, end, S(0), S(0));
}

}  // namespace refitlab

// Sources: none.
// Used by: c7_crossfade; algorithms/bake/over_time/bound_over_time.cpp, algorithms/bake/over_time/moving_vertices.cpp,
// experiments/drawings/motion.cpp.
