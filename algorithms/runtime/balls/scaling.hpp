// SPDX-License-Identifier: MIT
// If the lengths of a cloud are so small or so large that their higher powers leave the range of float or double, a power of two
// brings it to a size of about 1, without rounding.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace refitlab {

// Returns the exponent of the power of two by which lengths up to this one are divided, so that they are about 1. It is 0 if
// their fourth powers keep all digits as they are, and for 0, infinity and NaN.
template <class S>
int scaling_of(S greatest_length) {
  static_assert(std::is_floating_point_v<S>);
  constexpr int most = std::numeric_limits<S>::max_exponent / 16;  // lengths from 2^-64 to 2^64, in float 2^-8 to 2^8
  if (!(greatest_length > 0) || !std::isfinite(greatest_length)) return 0;
  const int exponent = std::ilogb(greatest_length);
  return exponent < -most || exponent > most ? exponent : 0;
}

// Returns x 2^by, coordinate by coordinate.
template <class Vector>
Vector times_power_of_two(const Vector& x, int by) {
  Vector out = x;
  for (int i = 0; i < out.size(); ++i) out[i] = std::scalbn(x[i], by);
  return out;
}

}  // namespace refitlab
