// SPDX-License-Identifier: MIT
// A body's placement in the world is checked here, and boxes are moved by it.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "algorithms/runtime/balls/box.hpp"
#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

// Placing two bodies may lose this share of the coordinates' size; see collide.cpp.
inline constexpr double lost_of_placements = 160 * 0x1p-53;

// Throws std::invalid_argument for a placement that is not finite or whose rotation differs from unit length by more than
// 1e-6. The message contains the given name.
inline void check_placement(const RigidTransform<double>& placement, const std::string& of, const char* name) {
  if (!placement.rotation.allFinite() || !placement.translation.allFinite())
    throw std::invalid_argument(of + ": " + name + " is not finite");
  if (!(std::abs(squared_norm(placement.rotation) - 1) <= 1e-6))
    throw std::invalid_argument(of + ": " + name + " is not rigid: its rotation is no quaternion of unit length");
}

// Moves a box whose coordinates may be off by lost, and grows it by that and by the roundings of this.
inline void move_box(Box<double>& box, const Point3& by, double lost) {
  for (int i = 0; i < 3; ++i) {
    double &low = box.low[i], &high = box.high[i];
    const double off = lost + 1e-14 * (std::max(std::abs(low), std::abs(high)) + std::abs(by[i]));
    low += by[i] - off, high += by[i] + off;
  }
}

}  // namespace refitlab
