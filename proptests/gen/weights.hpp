// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational convex weights of W_n, often weight vertices or with entries that are zero.
#pragma once

#include "proptests/gen/rational.hpp"

namespace proptests::gen {

// Draws n weights that are non-negative and sum to 1. About a third of them are zero, and a tenth of the lists are a weight
// vertex (0, .., 1, .., 0). Shrinks towards equal weights.
rc::Gen<std::vector<Rational>> convex_weights(int n);

}  // namespace proptests::gen
