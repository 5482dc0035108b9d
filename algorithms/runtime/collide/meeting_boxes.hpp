// SPDX-License-Identifier: MIT
// This is the broad phase: which of many boxes meet.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "algorithms/runtime/balls/box.hpp"

namespace refitlab {

// Returns the pairs of boxes that are not apart, each with the smaller index first, in increasing order. Boxes may be infinite, but
// no side may be NaN. For n boxes that are spread over a plane, and as large as their distances, it takes O(n log n) time; in any
// case O(n^2) time, and O(n^1.5) memory besides the result.
std::vector<std::pair<int, int>> meeting_boxes(std::span<const Box<double>> boxes);

}  // namespace refitlab
