// SPDX-License-Identifier: MIT
// The radius of a ball that was measured in float or double is raised by more than the rounding of the measurement.
#pragma once

#include <limits>

#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns the most that underflow may take from a radius. Sums and differences never underflow, and a product is off by at most
// the least number, 2^-1074 in double and 2^-149 in float. A value that is linear in lengths is off by a few of those. A
// distance, as the root of at most four squares, is off by 2 times their root, which is 2^-536 and 2^-73.5. A radius is made of a
// few distances. If numbers that underflow become 0, as in many other programs, the least numbers are 2^-1022 and 2^-126, and the
// distances are off by 2^-510 and 2^-62. The rest is for divisions of a distance by less than 1, as by the cosine of a blend to
// its axis, in double (algorithms/runtime/refit/refit_dual_quaternion.hpp).
template <class S>
constexpr S underflow_of_distance() {
  static_assert(std::is_same_v<S, double> || std::is_same_v<S, float>);
  return std::is_same_v<S, double> ? S(0x1p-480) : S(0x1p-60);
}

// Returns a ball of slightly greater radius that encloses some balls [c_k, r_k], although the radius was rounded. It was computed
// as the greatest norm(c_k - center) + r_k, by squared distances and roots. With u = epsilon / 2: differences, squares and sums
// of at most four squares make a squared distance off by at most 6 u of itself, its root by 4 u with its own rounding, the sum by
// 5 u, and one more sum by 6 u. Sixteen also cover what is rounded here. Infinity and NaN stay.
template <class S, int D>
Ball<S, D> rounded_up(const Ball<S, D>& measured) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  return {measured.center, measured.radius * (S(1) + 16 * u) + underflow_of_distance<S>()};
}

// Rounds to float so that the result encloses the ball, whatever the rounding. Beyond the range of float it is all of space.
inline Ball3<float> rounded_outward(const Ball3<double>& ball) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Vec<float, 3> center = ball.center.cast<float>();
  const Ball3<double> about =
      rounded_up(Ball3<double>{ball.center, norm<double, 3>(center.cast<double>() - ball.center) + ball.radius});
  if (!(about.radius < std::numeric_limits<float>::max())) return {Vec<float, 3>::Constant(0), infinity};
  return {center, std::nextafter(static_cast<float>(about.radius), infinity)};
}

}  // namespace refitlab
