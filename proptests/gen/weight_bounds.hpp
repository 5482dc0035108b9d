// SPDX-License-Identifier: GPL-3.0-or-later
// Weight bounds of a joint-set with their corners, and weights that they admit.
#pragma once

#include "lemmas/vocabulary/weights.hpp"
#include "proptests/gen/rational.hpp"

namespace proptests::gen {

using RationalWeights = std::vector<Rational>;
using RationalBounds = refitlab::WeightBounds<Rational>;

struct BoundsWithCorners {
  RationalBounds bounds;
  std::vector<RationalWeights> corners;  // all of them
};

// Bounds of n weights as they come from vertices: the least and the greatest of one to four weight vectors. One vertex
// (so one corner), fixed weights and the whole of W_n come up often.
rc::Gen<BoundsWithCorners> bounds_of_vertices(int n);
// The same for 1 to most weights.
rc::Gen<BoundsWithCorners> any_bounds_of_vertices(int most);
// Any numbers in [0, 1] as bounds: two in three let no weights through.
rc::Gen<RationalBounds> arbitrary_bounds(int most);

// Weights that the bounds admit, made without the corners: a point of the box, moved along the box until it sums to 1.
// Points of the boundary come up often. The bounds admit some.
rc::Gen<RationalWeights> admissible_weights(const RationalBounds& bounds);

void showValue(const BoundsWithCorners& b, std::ostream& out);

}  // namespace proptests::gen

namespace refitlab {
void showValue(const WeightBounds<Rational>& bounds, std::ostream& out);
}  // namespace refitlab
