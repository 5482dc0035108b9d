// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational vectors of R^d, d = 1, 2, 3, 4, often the zero vector or a coordinate axis.
#pragma once

#include "proptests/gen/rational.hpp"

namespace proptests::gen {

template <int D>
using RationalVec = refitlab::Vec<Rational, D>;

template <int D>
rc::Gen<RationalVec<D>> rational_vector();

// Draws the same without 0; shrinks towards vectors with few and small components.
template <int D>
rc::Gen<RationalVec<D>> nonzero_vector();

// Draws between low and high vectors (a list of points, say). A third of the lists repeat one of their vectors.
template <int D>
rc::Gen<std::vector<RationalVec<D>>> vectors(int low, int high);

}  // namespace proptests::gen
