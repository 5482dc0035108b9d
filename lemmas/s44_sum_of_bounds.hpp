// SPDX-License-Identifier: MIT
// Section 4.4, adding the bounds: the sum of the linear and the spherical part is in one ball of equal balls.
//
// Statement. Let the linear part be in CH(r'_1, ..., r'_m), the spherical part of the center in the ball F = [f, s],
// and let a ball [g, R] enclose the m equal balls r'_k (+) F. Then every sum of the two parts and of an offset of at
// most r is in [g, R + r]. Moreover CH(r'_1 (+) F, ..., r'_m (+) F) = CH(r'_1, ..., r'_m) (+) F, so nothing is lost but
// the shape. A ball encloses [x, s] if and only if it encloses the point of [x, s] that is farthest from its center.
//
// Paper: section 4.4, first paragraph; line 16 of Algorithm 1. It holds as printed.
// Notation: r'_k -> linear[k], F -> spherical, r -> inflation, u -> coefficients, the result before line 16 -> ball.
//
// Proof. f + sum u_k r'_k is in [g, R - s], which is convex and holds all f + r'_k. The spherical part moves it by at
// most s, the offset by at most r. For the equality: sum u_k (r'_k + f_k) = sum u_k r'_k + sum u_k f_k, and F is
// convex.
#pragma once

#include <span>
#include <vector>

#include "lemmas/vocabulary/sphere.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

template <class S>
struct PartBounds {
  std::vector<Vec<S, 3>> linear;  // r'_1 ... r'_m
  Ball3<S> spherical;             // F
  S inflation;                    // r
};

// A deformed vertex is the sum of these parts.
template <class S>
struct Parts {
  std::vector<S> coefficients;  // the linear part is sum_k u_k r'_k
  Vec<S, 3> spherical;          // Q_w(p - r_c), in F
  Vec<S, 3> offset;             // y of s43_minkowski_sum, ||y|| <= r
};

// --- Hypotheses ---

template <class S>
Verdict parts_are_bounded(const PartBounds<S>& bounds, const Parts<S>& parts) {
  return verdict_of(parts.coefficients.size() == bounds.linear.size()) & is_convex<S>(parts.coefficients) &
         encloses(bounds.spherical, parts.spherical) & less_equal(squared_norm(parts.offset), sq(bounds.inflation));
}

// The ball encloses r'_k (+) F for all k.
template <class S>
Verdict encloses_equal_balls(const Ball3<S>& ball, const PartBounds<S>& bounds) {
  Verdict v = verdict_of(!bounds.linear.empty());
  for (const auto& r : bounds.linear) v &= encloses(ball, Ball3<S>{r + bounds.spherical.center, bounds.spherical.radius});
  return v;
}

template <class S>
Verdict sum_of_bounds_hypotheses(const Ball3<S>& ball, const PartBounds<S>& bounds, const Parts<S>& parts) {
  return encloses_equal_balls(ball, bounds) & parts_are_bounded(bounds, parts) & less_equal(S(0), bounds.inflation);
}

// --- Witness and its check ---

// The witness leads from the ball's center to the vertex in three steps, which are at most R - s, s and r long.
template <class S>
struct SumSteps {
  Vec<S, 3> to_center, to_spherical, to_offset;
};

template <class S>
Verdict is_sum_steps(const Ball3<S>& ball, const PartBounds<S>& bounds, const Vec<S, 3>& vertex, const SumSteps<S>& steps) {
  const S slack = ball.radius - bounds.spherical.radius;
  Verdict v = less_equal(S(0), slack) & less_equal(squared_norm(steps.to_center), sq(slack)) &
              less_equal(squared_norm(steps.to_spherical), sq(bounds.spherical.radius)) &
              less_equal(squared_norm(steps.to_offset), sq(bounds.inflation));
  const Vec<S, 3> reached = ball.center + steps.to_center + steps.to_spherical + steps.to_offset;
  for (int i = 0; i < 3; ++i) v &= equal(reached[i], vertex[i]);
  return v;
}

// --- Conclusion ---

template <class S>
struct SumOfBounds {
  Verdict verdict;
  Vec<S, 3> vertex;
  SumSteps<S> steps;
};

template <class S>
SumOfBounds<S> sum_of_bounds(const Ball3<S>& ball, const PartBounds<S>& bounds, const Parts<S>& parts) {
  const Vec<S, 3> linear = combine<S, 3>(parts.coefficients, bounds.linear);
  const Vec<S, 3> vertex = linear + parts.spherical + parts.offset;
  const SumSteps<S> steps{linear + bounds.spherical.center - ball.center, parts.spherical - bounds.spherical.center,
                          parts.offset};
  return {encloses(inflate(ball, bounds.inflation), vertex), vertex, steps};
}

// A point of CH(r'_1 (+) F, ..., r'_m (+) F) is taken apart: its linear part is sum u_k r'_k, and the rest is in F.
template <class S>
struct HullOfBallsPoint {
  Verdict verdict;
  Vec<S, 3> linear, spherical;
};

// points[k] is in r'_k (+) F.
template <class S>
HullOfBallsPoint<S> hull_of_balls_in_sum(const PartBounds<S>& bounds, std::span<const Vec<S, 3>> points,
                                         std::span<const S> coefficients) {
  const Vec<S, 3> linear = combine<S, 3>(coefficients, bounds.linear);
  const Vec<S, 3> spherical = combine(coefficients, points) - linear;
  return {encloses(bounds.spherical, spherical), linear, spherical};
}

// Returns the point of the inner ball that is farthest from a given one. It takes a root, which the decision does not need.
template <class S>
Vec<S, 3> farthest_point(const Ball3<S>& inner, const Vec<S, 3>& from) {
  const Vec<S, 3> away = inner.center - from;
  const S distance = norm(away);
  if (!certainly_less(S(0), distance)) return inner.center + Vec<S, 3>(inner.radius, S(0), S(0));
  return inner.center + away * S(inner.radius / distance);
}

// outer encloses inner if and only if it encloses that one point.
template <class S>
Verdict farthest_point_decides(const Ball3<S>& outer, const Ball3<S>& inner) {
  const Verdict ball = encloses(outer, inner), point = encloses(outer, farthest_point(inner, outer.center));
  return implies(ball, point) & implies(point, ball);
}

}  // namespace refitlab

// Sources: the paper.
// Used by: no program.
