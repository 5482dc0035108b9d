// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the weight vertices of a polytope that holds given weight vectors. The polytope is their own convex hull, or the
// box around them cut by sum w = 1, whichever has fewer weight vertices.
#pragma once

#include <span>
#include <vector>

namespace refitlab {

// weights has at least one row. Each row has n convex weights, all multiples of 2^-24. Every row is a convex combination of
// the returned weight vertices.
std::vector<std::vector<double>> weight_polytope(const std::vector<std::span<const double>>& weights);

// Returns the extreme points among rows with n <= 4 weights, exactly. For n = 2 they are the interval's ends; for n = 3 and
// 4 they come from a convex hull in the plane and in space with exact predicates. For n > 4 it returns all distinct rows.
// Their order does not depend on the order of weights.
std::vector<std::vector<double>> extreme_rows(const std::vector<std::span<const double>>& weights);

}  // namespace refitlab
