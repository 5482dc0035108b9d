// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b5_rotation_axis.
#pragma once

#include "lemmas/b5_rotation_axis.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b5 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;
using Fallback = refitlab::CapFallback<Q>;

inline const Point x_axis(1, 0, 0), y_axis(0, 1, 0);
inline const std::vector<Point> at_origin{Point(0, 0, 0), Point(0, 0, 0)};
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)}, all{1};

// This is a twist about the x axis with the cap cos alpha = 7/25. A point of the axis does not move; the paper's ball for it has
// the squared radius 576/625.
inline const Fallback twist{
    {Rotation(Q(4, 5), Q(3, 5), 0, 0), Rotation(Q(4, 5), Q(-3, 5), 0, 0)}, at_origin, Rotation(1, 0, 0, 0), Q(16, 25)};

// The second turns about another axis: a point of the first axis moves.
inline const Fallback two_axes{
    {Rotation(Q(4, 5), Q(3, 5), 0, 0), Rotation(Q(4, 5), 0, Q(3, 5), 0)}, at_origin, Rotation(1, 0, 0, 0), Q(16, 25)};

}  // namespace proptests::b5
