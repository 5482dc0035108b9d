// SPDX-License-Identifier: MIT
// Refits in single precision square their lengths, which limits their range.
#pragma once

#include <sstream>
#include <stdexcept>

namespace refitlab {

// Up to this length, no square that a refit computes is beyond the range of float.
inline constexpr double largest_single_length = 0x1p58;

// Returns length itself. Throws std::range_error if it is too large.
inline double checked_single(double length) {
  if (length <= largest_single_length) return length;
  std::ostringstream message;
  message << "refit in single precision: a length of " << length << " is out of range, which ends at " << largest_single_length;
  throw std::range_error(message.str());
}

}  // namespace refitlab
