// SPDX-License-Identifier: MIT
// The range of refits in single precision, which square their lengths.
#pragma once

#include <sstream>
#include <stdexcept>

namespace refitlab {

// Up to here no square of a length that a refit comes across is beyond the range of float.
inline constexpr double largest_single_length = 0x1p58;

// length itself. Throws std::range_error where it is too large.
inline double checked_single(double length) {
  if (length <= largest_single_length) return length;
  std::ostringstream message;
  message << "refit in single precision: a length of " << length << " is out of range, which ends at " << largest_single_length;
  throw std::range_error(message.str());
}

}  // namespace refitlab
