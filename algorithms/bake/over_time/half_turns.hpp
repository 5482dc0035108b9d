// SPDX-License-Identifier: GPL-3.0-or-later
// Two rotations that are half a turn apart are blended either way, by the sign of their quaternions' dot product. A renderer in
// float may see the other sign.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/model.hpp"

namespace refitlab {

// The dot product is off by at most this in a renderer in float, whose rotations are off by up to 2^-19 each.
inline constexpr double rounding_of_cosine_in_float = 0x1p-18;

// Returns a sentence for each joint of each clip that turns by half a turn from one key to the next, to within that rounding.
// Bounds hold for the way of the exact sign. (Joints of one vertex that are half a turn apart are bounded both ways, by
// MovingVertices.)
std::vector<std::string> half_turns(const Model& model);

}  // namespace refitlab
