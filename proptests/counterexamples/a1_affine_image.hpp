// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of a1_affine_image: a joint that scales.
#pragma once

#include "lemmas/a1_affine_image.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::a1 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Map = refitlab::AffineMap<Q>;

// One map is twice as long along x; the other is a shear whose greatest stretch, some 1.62, is less than the bound's sqrt(3).
inline const Map twice{{Point(2, 0, 0), Point(0, 1, 0), Point(0, 0, 1)}, Point(0, 0, 0)},
    shear{{Point(1, 0, 0), Point(1, 1, 0), Point(0, 0, 1)}, Point(5, 0, 0)};
inline const refitlab::SquaredBall<Q, 3> unit_ball{Point(0, 0, 0), 1};
inline const Point pole(1, 0, 0);
inline const std::vector<Q> beyond{2, -1};

}  // namespace proptests::a1
