// SPDX-License-Identifier: GPL-3.0-or-later
// Draws weight bounds that are multiples of 2^-24, as models have them: they are exact in double and as rationals.
#pragma once

#include <rapidcheck.h>

#include <vector>

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace proptests::gen {

struct DyadicBounds {
  std::vector<int> low, high;  // in units of 2^-24, low <= high

  template <class S>
  refitlab::WeightBounds<S> as() const {
    refitlab::WeightBounds<S> out;
    for (const int x : low) out.low.push_back(S(static_cast<double>(x)) / S(static_cast<double>(1 << 24)));
    for (const int x : high) out.high.push_back(S(static_cast<double>(x)) / S(static_cast<double>(1 << 24)));
    return out;
  }
  // Says whether a weight is fixed, there are no weights at all, or weights are only at the very end of the box.
  bool is_degenerate() const;
};

// Draws boxes of 1 to most weights that mostly let some through. A third of them have fixed weights, a fifth touch the plane of
// sum 1 in one point only, and some miss it.
rc::Gen<DyadicBounds> dyadic_bounds(int most);

void showValue(const DyadicBounds& bounds, std::ostream& out);

}  // namespace proptests::gen
