// SPDX-License-Identifier: MIT
// These are the policies for BOUNDINGSPHERE, the subroutine of Algorithm 1 in which the variants differ. They make mean balls, as
// printed, smallest balls, or balls that are nearly the smallest.
#pragma once

#include <vector>

#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/balls/first_balls_ball.hpp"
#include "algorithms/runtime/balls/mean_ball.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace refitlab {

struct MeanBalls {
  template <class S, int D>
  static Vec<S, D> center_of_points(std::span<const Vec<S, D>> points) {
    return mean_center(points);
  }
  template <class S>
  static Ball3<S> of_balls(std::span<const Ball3<S>> balls) {
    return mean_ball(balls);
  }
};

struct SmallestBalls {
  template <class S, int D>
  static Vec<S, D> center_of_points(std::span<const Vec<S, D>> points) {
    if constexpr (std::is_floating_point_v<S>) return few_points_ball<S, D>(points).center;
    else return smallest_ball(points).center;
  }
  static Ball3<double> of_balls(std::span<const Ball3<double>> balls) { return few_balls_enclosing(balls); }
};

// Makes a ball that is larger than the smallest by at most the share slack. A few of the balls determine the smallest; the
// balls that come first are tried first.
struct NearSmallestBalls {
  static constexpr double slack = 0.05;
  static Ball3<double> of_balls(std::span<const Ball3<double>> balls) {
    if (balls.size() > 1)
      if (const auto near = first_balls_ball(balls, slack)) return *near;
    return few_balls_enclosing(balls, slack);
  }
};

// The lists of Algorithm 1 are kept between calls, so that a refit does not allocate.
template <class S>
struct RefitLists {
  std::vector<Ball3<S>> balls;             // L_1
  std::vector<Quaternion<S>> quaternions;  // L_2
};

}  // namespace refitlab
