// SPDX-License-Identifier: GPL-3.0-or-later
// Draws weight bounds of a joint-set with their weight vertices, and weights that they admit.
#pragma once

#include "lemmas/vocabulary/weights.hpp"
#include "proptests/gen/rational.hpp"

namespace proptests::gen {

using RationalWeights = std::vector<Rational>;
using RationalBounds = refitlab::WeightBounds<Rational>;

struct WeightPolytope {
  RationalBounds bounds;
  std::vector<RationalWeights> vertices;  // all of them
};

// Draws bounds of n weights as they come from vertices: the least and the greatest of one to four weight vectors. One vertex (so
// one weight vertex), fixed weights and the whole of W_n come up often.
rc::Gen<WeightPolytope> bounds_of_vertices(int n);
// Draws the same for 1 to most weights.
rc::Gen<WeightPolytope> any_bounds_of_vertices(int most);
// Draws any numbers in [0, 1] as bounds. Two in three let no weights through.
rc::Gen<RationalBounds> arbitrary_bounds(int most);

// Draws weights that the bounds admit, made without the weight vertices: a point of the box, moved along the box until it sums to
// 1. Points of the boundary come up often. The bounds must admit some.
rc::Gen<RationalWeights> admissible_weights(const RationalBounds& bounds);

void showValue(const WeightPolytope& b, std::ostream& out);

}  // namespace proptests::gen

namespace refitlab {
void showValue(const WeightBounds<Rational>& bounds, std::ostream& out);
}  // namespace refitlab
