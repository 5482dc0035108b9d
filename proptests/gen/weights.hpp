// SPDX-License-Identifier: GPL-3.0-or-later
// Rational convex weights of W_n, with weight vertices and zero entries at a good share.
#pragma once

#include "proptests/gen/rational.hpp"

namespace proptests::gen {

// n weights that are non-negative and sum to 1: about a third of them zero; a tenth of the lists are a weight vertex
// (0, .., 1, .., 0). Shrinks towards equal weights.
rc::Gen<std::vector<Rational>> convex_weights(int n);

}  // namespace proptests::gen
