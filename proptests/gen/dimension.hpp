// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a property over spaces of several dimensions: one of R^low ... R^high is drawn for each case.
#pragma once

#include <rapidcheck.h>

#include <type_traits>

namespace proptests::gen {

template <int D>
using Dimension = std::integral_constant<int, D>;

// Calls property(Dimension<d>{}) with d drawn from low ... high; shrinks towards low.
template <int Low, int High, class Property>
void for_some_dimension(const Property& property, int d = *rc::gen::inRange(Low, High + 1).as("dimension")) {
  if constexpr (Low < High) {
    if (d != Low) return for_some_dimension<Low + 1, High>(property, d);
  }
  property(Dimension<Low>{});
}

}  // namespace proptests::gen
