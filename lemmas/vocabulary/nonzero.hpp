// SPDX-License-Identifier: MIT
// These decide whether a blended quaternion is a rotation, that is, certainly not 0, also where it was computed with rounding.
#pragma once

#include <type_traits>

#include "lemmas/vocabulary/numbers.hpp"

namespace refitlab {

// A blended quaternion whose squared length is not certainly above this may be 0 in truth: what is left of it may be
// rounding. Exact numbers and intervals know.
template <class S>
constexpr double least_squared_length() {
  if constexpr (HasLanes<S>) return least_squared_length<typename NumberTraits<S>::Lane>();
  else if constexpr (std::is_same_v<S, double>) return 0x1p-40;
  else if constexpr (std::is_same_v<S, float>) return 0x1p-16;
  else return 0;
}

// Returns whether a quaternion of this squared length is a rotation beyond doubt, for packs by lane.
template <class S>
auto is_certainly_nonzero(const S& squared_length) {
  return certainly_less(constant<S>(least_squared_length<S>()), squared_length);
}

}  // namespace refitlab
