// SPDX-License-Identifier: MIT
// These return the least float that is not below a double, and the greatest that is not above it.
#pragma once

#include <cmath>
#include <limits>

namespace refitlab {

inline float float_above(double x) {
  const auto f = static_cast<float>(x);
  return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

inline float float_below(double x) { return -float_above(-x); }

}  // namespace refitlab
