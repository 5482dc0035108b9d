// SPDX-License-Identifier: MIT
// Computes a ball near the smallest enclosing one, by a few cheap steps [Badoiu and Clarkson 2003, "Smaller core-sets for
// balls"].
#pragma once

#include <span>

#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// balls is not empty. Starts from the middle of the balls' bounding box; step i moves the center by the share 1/(i + 2)
// towards the ball that reaches farthest. The best center met is returned, with the radius that encloses all balls from
// there: at most sqrt(3) times the smallest, already from the first center (half the box's diagonal against half its
// longest edge).
template <class S>
Ball3<S> near_smallest_ball(std::span<const Ball3<S>> balls, int steps) {
  Vec<S, 3> low = balls[0].center - Vec<S, 3>::Constant(balls[0].radius);
  Vec<S, 3> high = balls[0].center + Vec<S, 3>::Constant(balls[0].radius);
  for (const auto& b : balls.subspan(1))
    for (int i = 0; i < 3; ++i) {
      low[i] = min_of(low[i], S(b.center[i] - b.radius));
      high[i] = max_of(high[i], S(b.center[i] + b.radius));
    }
  Ball3<S> best{(low + high) / S(2), S(0)};
  Vec<S, 3> center = best.center;
  for (int step = 0; step <= steps; ++step) {
    std::size_t farthest = 0;
    S reach = norm<S, 3>(balls[0].center - center) + balls[0].radius;
    for (std::size_t i = 1; i < balls.size(); ++i) {
      const S r = norm<S, 3>(balls[i].center - center) + balls[i].radius;
      if (prefer_less(reach, r)) farthest = i;
      reach = max_of(reach, r);
    }
    if (step == 0 || prefer_less(reach, best.radius)) best = {center, reach};
    center = center + (balls[farthest].center - center) / S(step + 2);
  }
  return best;
}

}  // namespace refitlab
