// SPDX-License-Identifier: MIT
// ByJoint: an array of as many entries as a joint-set has joints, on the stack if the compiler knows how many these are.
#pragma once

#include <array>
#include <vector>

namespace refitlab {

// joints is their number, or 0 if that is only known at run time.
template <class T, int joints>
struct ByJoint : std::array<T, joints> {
  explicit ByJoint(int) {}
};
template <class T>
struct ByJoint<T, 0> : std::vector<T> {
  explicit ByJoint(int count) : std::vector<T>(count) {}
};

}  // namespace refitlab
