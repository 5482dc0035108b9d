// SPDX-License-Identifier: MIT
// Weights as multiples of 2^-24 that sum to 1 exactly.
//
// Weights in files sum to 1 only up to rounding. Rounded to multiples of 2^-24 (finer than the 8- and 16-bit weights of
// most files, and the resolution of float near 1) every weight, every partial sum and every corner of a weight box is
// exact in float and in double, so that the weight side of every statement is free of rounding.
#pragma once

#include <utility>
#include <vector>

namespace refitlab {

inline constexpr int weight_bits = 24;

// (joint, weight) pairs with finite weights >= 0 and a positive sum (the caller has checked): merges repeated joints,
// divides by the sum, rounds so that the total is 1 (largest remainders first), drops what rounds to 0, and sorts by
// joint. Each is less than 2^-24 from its share of the sum, up to the rounding of doubles; the order of the shares stays.
std::vector<std::pair<int, double>> quantize_weights(std::vector<std::pair<int, double>> weights);

}  // namespace refitlab
