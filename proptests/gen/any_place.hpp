// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one of several with equal chances.
#pragma once

#include <rapidcheck.h>

#include <cstddef>

namespace proptests::gen {

// Returns a place from 0 to n - 1. Each is as likely as any other at all sizes, where rc::gen::inRange prefers small ones if sizes
// are small.
inline std::size_t any_place(std::size_t n) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, n)); }

}  // namespace proptests::gen
