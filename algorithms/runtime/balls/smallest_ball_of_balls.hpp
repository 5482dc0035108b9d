// SPDX-License-Identifier: MIT
// Computes the smallest enclosing ball of any number of balls of R^3, however they lie. It is slower than few_balls_ball.hpp,
// which calls it where its own pivots fail.
#pragma once

#include <span>

#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// balls is not empty. The ball is smallest up to rounding; the radius is then raised to what encloses all balls as computed in
// double. If one of the balls is undefined (not finite, or of negative radius), so is the result: all of it is NaN.
Ball3<double> smallest_ball_of_balls(std::span<const Ball3<double>> balls);

}  // namespace refitlab
