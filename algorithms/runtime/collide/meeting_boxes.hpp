// SPDX-License-Identifier: MIT
// This is the broad phase: which of many boxes meet.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "algorithms/runtime/balls/box.hpp"

namespace refitlab {

// Returns the pairs of boxes that are not apart, each with the smaller index first, in increasing order. Boxes may be infinite, but
// no side may be NaN, and no low side greater than the high one. For n boxes that are spread over a rectangle of a plane, and are
// about as large as their distances, it takes O(n log n) time. It never takes more than O(n^2.5) time, nor more than O(n^1.5) memory
// besides the result; so much it takes if half of the boxes are infinite.
std::vector<std::pair<int, int>> meeting_boxes(std::span<const Box<double>> boxes);

}  // namespace refitlab
