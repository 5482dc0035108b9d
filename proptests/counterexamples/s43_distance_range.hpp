// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s43_distance_range: what goes wrong without each hypothesis, and where the paper is wrong.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s43_distance_range.hpp"

namespace proptests::s43_range {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 2>;

struct Case {
  Point center;
  // distance is d_H, and 0 where there is none.
  Q radius, distance;
};

// The printed conditions are ||c|| + r >= 1 and r < 1. A ball outside the unit circle that does not touch it has d_H = 13/8.
inline const Case outside{Point(3, 0), Q(1, 2), Q(13, 8)};
// A ball inside it that does not touch it has d_H = 19/16.
inline const Case inside{Point(Q(1, 2), 0), Q(1, 4), Q(19, 16)};
// One that holds more than half of the circle has d_H = -1/8.
inline const Case past_half{Point(1, 0), Q(3, 2), Q(-1, 8)};
// A ball about 0 has no direction and no distance.
inline const Case about_zero{Point(0, 0), Q(1), Q(0)};

// A point in the ball is not on the unit circle: the ball is that point, with d_H = 5/4.
inline const Point not_unit(2, 0);

}  // namespace proptests::s43_range
