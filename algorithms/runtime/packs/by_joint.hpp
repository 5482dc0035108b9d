// SPDX-License-Identifier: MIT
// ByJoint is an array with an entry for each joint of a joint-set. It is on the stack if the compiler knows their number.
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
