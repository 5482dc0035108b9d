// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b1_rational_bezier_simplex: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b1 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;

// One weight vertex keeps x and moves the center: with the weight 2 the linear part counts twice, but its control point counts
// once.
inline const refitlab::SphericalBlend<Q> moved{{Rotation(1, 0, 0, 0)}, {Point(1, 0, 0)}, Point(0, 1, 0)};
inline const std::vector<Q> twice{2};

// Two quaternions of one rotation cancel: no image is the only one, and any point is an image.
inline const refitlab::SphericalBlend<Q> cancelling{
    {Rotation(1, 0, 0, 0), Rotation(-1, 0, 0, 0)}, {Point(0, 0, 0), Point(0, 0, 0)}, Point(0, 1, 0)};
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)};
inline const Point here(0, 1, 0), elsewhere(7, 0, 0);

}  // namespace proptests::b1
