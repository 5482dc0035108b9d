// SPDX-License-Identifier: GPL-3.0-or-later
// Draws lists of a generated length, of which a third repeat one of their elements: repeated points are a degenerate case.
#pragma once

#include <rapidcheck.h>

#include <vector>

namespace proptests::gen {

// Draws between low and high elements (low >= 1); shrinks towards fewer and simpler ones.
template <class T>
rc::Gen<std::vector<T>> list_with_repeats(int low, int high, rc::Gen<T> element) {
  const auto fresh = rc::gen::mapcat(rc::gen::inRange(low, high + 1),
                                     [element](int n) { return rc::gen::container<std::vector<T>>(n, element); });
  return rc::gen::apply(
      [](std::vector<T> list, int kind) {
        if (kind == 2) list.back() = list.front();
        return list;
      },
      fresh, rc::gen::inRange(0, 3));
}

}  // namespace proptests::gen
