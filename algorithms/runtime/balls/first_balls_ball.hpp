// SPDX-License-Identifier: MIT
// Computes a ball near the smallest one around some balls, if the first balls are likely to be its support. Where they are, one
// pass is enough.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "algorithms/runtime/balls/ball_about.hpp"
#include "algorithms/runtime/balls/three_points_ball.hpp"

namespace refitlab {

// Returns the smallest ball of two balls, which are defined.
inline Ball3<double> two_balls_ball(const Ball3<double>& a, const Ball3<double>& b) {
  const Vec<double, 3> way = b.center - a.center;
  const double length = norm(way), radius = (length + a.radius + b.radius) / 2;
  if (radius <= a.radius) return a;
  if (radius <= b.radius) return b;
  return {a.center + way * ((radius - a.radius) / length), radius};
}

// Returns the ball about a center that encloses all balls, as computed. If its radius is greater than the given one, there is no
// result.
inline std::optional<Ball3<double>> ball_up_to(const Vec<double, 3>& center, double radius,
                                               std::span<const Ball3<double>> balls) {
  if (!(radius < std::numeric_limits<double>::infinity())) return std::nullopt;
  double squared = 0, least = balls[0].radius, greatest = least;
  for (const auto& b : balls) {
    const double d = squared_distance(b.center, center), room = radius - b.radius;
    if (!(d <= sq(room) && 0 <= room)) return std::nullopt;
    squared = max_of(squared, d);
    least = min_of(least, b.radius), greatest = max_of(greatest, b.radius);
  }
  if (!(least >= 0)) return std::nullopt;
  if (least == greatest) return Ball3<double>{center, root(squared) + least};
  return ball_about<double, 3>(center, balls);
}

// Takes the smallest ball of the first two balls, or of the first three if these have one radius. No ball around all balls is
// smaller. If a ball about its center with at most 1 + slack times its radius encloses all, the result is the least such ball, as
// computed; else there is none. There are at least two balls.
inline std::optional<Ball3<double>> first_balls_ball(std::span<const Ball3<double>> balls, double slack) {
  const Ball3<double>&a = balls[0], &b = balls[1];
  if (balls.size() == 2 || a.radius != b.radius || a.radius != balls[2].radius) {
    const Ball3<double> two = two_balls_ball(a, b);
    return ball_up_to(two.center, two.radius * (1 + slack), balls);
  }
  const auto three = three_points_ball(a.center, b.center, balls[2].center);
  const double radius = root(three.squared_radius) + a.radius;
  if (balls.size() == 3 && a.radius >= 0 && radius < std::numeric_limits<double>::infinity())
    return Ball3<double>{three.center, radius};
  return ball_up_to(three.center, radius * (1 + slack), balls);
}

}  // namespace refitlab
