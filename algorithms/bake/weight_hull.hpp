// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of a polytope that holds given weight vectors: their own convex hull, or the box around them cut by sum w = 1,
// whichever has fewer corners.
#pragma once

#include <span>
#include <vector>

namespace refitlab {

// weights: rows of n convex weights each, all multiples of 2^-24, at least one row. Every row is a convex combination of
// the corners returned.
std::vector<std::vector<double>> weight_polytope(const std::vector<std::span<const double>>& weights);

// The extreme points among rows with n <= 4 weights, exactly (n = 2: the interval's ends; n = 3 and 4: a convex hull in
// the plane and in space with exact predicates). For n > 4 all distinct rows. Their order does not depend on that of
// weights.
std::vector<std::vector<double>> extreme_rows(const std::vector<std::span<const double>>& weights);

}  // namespace refitlab
