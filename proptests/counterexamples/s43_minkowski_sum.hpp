// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s43_minkowski_sum: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s43_minkowski_sum.hpp"

namespace proptests::s43_minkowski {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;

inline const refitlab::Ball3<Q> unit_ball{Point(0, 0, 0), Q(1)};
inline const Point pivot(0, 0, 0);

// By the zero blend every point is an image of every point, so the image of the center's neighbour may be 2 away.
inline const refitlab::Quaternion<Q> zero_blend(0, 0, 0, 0);
inline const Point anywhere(2, 0, 0);

// A box stands in place of the ball: turned about z by the angle with cosine 3/5, the corner (1, 1, 1) of the box [-1, 1]^3
// leaves it.
inline const refitlab::Quaternion<Q> turn(2, 0, 0, 1);
inline const Point box_corner(1, 1, 1);

}  // namespace proptests::s43_minkowski
