// SPDX-License-Identifier: MIT
// The mean ball is centered at the mean of the centers, with the smallest radius that encloses all (paper 4.4, the BOUNDINGSPHERE
// of Algorithm 1 [James and Pai 2004]). In float and double the ball may miss some by rounding; rounded_up (round_up.hpp) makes
// up for that.
#pragma once

#include <span>

#include "algorithms/runtime/balls/ball_about.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

template <class S, int D>
Vec<S, D> mean_center(std::span<const Vec<S, D>> points) {
  Vec<S, D> sum = points[0];
  for (const auto& p : points.subspan(1)) sum = sum + p;
  return sum / S(static_cast<double>(points.size()));
}

template <class S, int D>
S farthest_squared_distance(const Vec<S, D>& center, std::span<const Vec<S, D>> points) {
  S far = squared_distance(points[0], center);
  for (const auto& p : points.subspan(1)) far = max_of(far, squared_distance(p, center));
  return far;
}

// Returns the mean ball of m points, m > 0. The radius is at most max(2 - 2/m, 1) times the smallest ball's. Proof:
// let the smallest ball be [0, R]. Then ||p_j - mean|| <= (1 - 1/m) ||p_j|| + sum over the others of ||p_i|| / m <= (2 - 2/m) R.
// It reaches this bound if one point is x and all others are -x.
template <class S, int D>
Ball<S, D> mean_ball(std::span<const Vec<S, D>> points) {
  const Vec<S, D> center = mean_center(points);
  return {center, root(farthest_squared_distance(center, points))};
}

// Returns the mean ball of m balls, m > 0. The radius is at most 2 - 1/m times the smallest ball's, by the same steps with
// ||p_i|| + r_i <= R, and reaches this bound if one ball is [0, R] and all others are the same point at distance R.
template <class S, int D>
Ball<S, D> mean_ball(std::span<const Ball<S, D>> balls) {
  Vec<S, D> sum = balls[0].center;
  for (const auto& b : balls.subspan(1)) sum = sum + b.center;
  return ball_about<S, D>(sum / S(static_cast<double>(balls.size())), balls);
}

}  // namespace refitlab
