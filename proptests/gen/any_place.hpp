// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one of several with equal chances. Each is as likely as any other at all sizes, where rc::gen::inRange prefers small ones if
// sizes are small.
#pragma once

#include <rapidcheck.h>

#include <cstddef>

namespace proptests::gen {

// Generates whole numbers from low to end - 1.
template <class T>
rc::Gen<T> between(T low, T end) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(low, end));
}

// Returns a place from 0 to n - 1.
inline std::size_t any_place(std::size_t n) { return *between<std::size_t>(0, n); }

}  // namespace proptests::gen
