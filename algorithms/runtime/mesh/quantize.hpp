// SPDX-License-Identifier: MIT
// Weights become multiples of 2^-24 that sum to 1 exactly.
//
// Weights in files sum to 1 only up to rounding. This header rounds them to multiples of 2^-24, which is finer than the 8-
// and 16-bit weights of most files, and is the resolution of float near 1. Then every weight, every partial sum and every
// weight vertex of a weight box is exact in float and in double. So the weight side of every statement is free of rounding.
#pragma once

#include <utility>
#include <vector>

namespace refitlab {

inline constexpr int weight_bits = 24;

// Takes (joint, weight) pairs with finite weights >= 0 and a positive sum (the caller has checked this). Merges repeated
// joints, divides by the sum, rounds so that the total is 1 (largest remainders first), drops weights that round to 0, and
// sorts by joint. Each weight is less than 2^-24 from its share of the sum, up to the rounding of doubles. The order of the
// shares stays the same.
// lost, where it is given, becomes the joints whose positive weights round to 0, each with its share of the sum in (0, 2^-24),
// sorted by joint.
std::vector<std::pair<int, double>> quantize_weights(const std::vector<std::pair<int, double>>& weights,
                                                     std::vector<std::pair<int, double>>* lost = nullptr);

}  // namespace refitlab
