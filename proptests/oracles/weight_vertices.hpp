// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the weight vertices of weight bounds from nothing in algorithms/: every pattern is tried, and hulls are descended pair
// by pair.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace proptests::oracle {

using ExactWeights = std::vector<refitlab::Rational>;
using ExactBounds = refitlab::WeightBounds<refitlab::Rational>;

// Returns those of all n 2^(n-1) choices of one loose coordinate and a bound for each other one that are admissible.
std::set<ExactWeights> weight_vertices(const ExactBounds& bounds);

// Returns admissible weights as a convex combination: weight vertices with positive coefficients. While two coordinates are off
// their bounds, the weights lie between the two ends of the line that trades one for the other.
std::map<ExactWeights, refitlab::Rational> as_combination_of_weight_vertices(const ExactBounds& bounds, const ExactWeights& w);

// Returns the least and the greatest weights of a list of weight vectors.
ExactBounds bounds_around(const std::vector<ExactWeights>& list);

}  // namespace proptests::oracle
