// SPDX-License-Identifier: MIT
// Computes the smallest enclosing ball of three points in closed form, because most nodes of a sphere tree are single triangles.
//
// If the angle at a point is not acute, the ball has the opposite side as a diameter. Else it is the ball of the circle
// through all three, whose center has the barycentric coordinates |bc|^2 (b - a, c - a) at a, and so on: in a triangle
// without an obtuse angle they are positive.
#pragma once

#include "algorithms/runtime/balls/smallest_ball.hpp"

namespace refitlab {

// Returns the least normal number, with room for all digits. Products above it lose none of them to underflow.
template <class S>
constexpr S tiny_ratio() {
  return std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();
}

// The radius is that of the farthest point as computed. If a point is not finite, the center and the radius are NaN.
// In double the radius is that of the smallest ball but for some roundings, times the ratio of the longest side to the shortest;
// the ball has the points nevertheless. Only + - * / are needed. Angles are right from 2^-970 on in double, and from 2^-103 on in
// float. If the fourth powers of the sides would be out of range, the coordinates are made of ratios.
template <class S, int D>
SmallestBall<S, D> three_points_ball(const Vec<S, D>& a, const Vec<S, D>& b, const Vec<S, D>& c) {
  const Vec<S, D> ab = b - a, bc = c - b, ca = a - c;
  const S at_a = -dot(ab, ca), at_b = -dot(bc, ab), at_c = -dot(ca, bc);
  S right(0);
  if constexpr (std::is_floating_point_v<S>) {
    const S size = at_a + at_b + at_c;
    if (!(size < std::numeric_limits<S>::infinity())) return undefined_smallest_ball<S, D>();
    right = size * tiny_ratio<S>();
  }
  SmallestBall<S, D> out;
  out.converged = true;
  const auto diameter = [&](int i, int j, const Vec<S, D>& p, const Vec<S, D>& side) {
    out.center = p + side / S(2);
    out.support = {i, j};
    out.coefficients = {S(1) / S(2), S(1) / S(2)};
    out.support_size = 2;
  };
  if (!(right < at_a)) {
    diameter(1, 2, b, bc);
  } else if (!(right < at_b)) {
    diameter(2, 0, c, ca);
  } else if (!(right < at_c)) {
    diameter(0, 1, a, ab);
  } else {
    S u = squared_norm(bc) * at_a, v = squared_norm(ca) * at_b, w = squared_norm(ab) * at_c;
    if constexpr (std::is_floating_point_v<S>)
      if (!(tiny_ratio<S>() < min_of(u, min_of(v, w)) && u + v + w < S(1) / tiny_ratio<S>())) {
        const S size = at_a + at_b + at_c;
        u = squared_norm(bc) / size * (at_a / size);
        v = squared_norm(ca) / size * (at_b / size);
        w = squared_norm(ab) / size * (at_c / size);
      }
    const S share = S(1) / (u + v + w);
    out.coefficients = {u * share, v * share, w * share};
    out.center = a + ab * out.coefficients[1] - ca * out.coefficients[2];
    out.support = {0, 1, 2};
    out.support_size = 3;
  }
  out.squared_radius = max_of(squared_distance(out.center, a), squared_distance(out.center, b));
  out.squared_radius = max_of(out.squared_radius, squared_distance(out.center, c));
  return out;
}

}  // namespace refitlab
