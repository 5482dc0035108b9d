// SPDX-License-Identifier: MIT
// The ball about a given center reaches as far as the farthest of some balls. In float and double it may miss some by rounding;
// rounded_up (round_up.hpp) makes up for that.
#pragma once

#include <span>

#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns the ball about a center that encloses balls, of which there is at least one, as computed.
template <class S, int D>
Ball<S, D> ball_about(const Vec<S, D>& center, std::span<const Ball<S, D>> balls) {
  S radius = norm<S, D>(balls[0].center - center) + balls[0].radius;
  for (const auto& b : balls.subspan(1)) radius = max_of(radius, S(norm<S, D>(b.center - center) + b.radius));
  return {center, radius};
}

}  // namespace refitlab
