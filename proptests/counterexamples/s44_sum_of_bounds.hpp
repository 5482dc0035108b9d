// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s44_sum_of_bounds: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s44_sum_of_bounds.hpp"

namespace proptests::s44_sum {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;

struct Case {
  refitlab::Ball3<Q> ball;
  refitlab::PartBounds<Q> bounds;
  refitlab::Parts<Q> parts;
};

// Here r'_1 = 0, r'_2 = (2, 0, 0), F = [0, 1] and r = 1. The smallest ball of both balls is [(1, 0, 0), 2]; with r its radius is
// 3.
inline const refitlab::PartBounds<Q> two_points{{Point(0, 0, 0), Point(2, 0, 0)}, {Point(0, 0, 0), 1}, 1};
inline const refitlab::Ball3<Q> around_both{Point(1, 0, 0), 2};
// The farthest vertex is at r'_2, with both other parts at their ends. It is on the boundary.
inline const Case extreme{around_both, two_points, {{0, 1}, Point(1, 0, 0), Point(1, 0, 0)}};

inline const Case not_convex{around_both, two_points, {{-1, 2}, Point(1, 0, 0), Point(1, 0, 0)}};
inline const Case spherical_outside{around_both, two_points, {{0, 1}, Point(2, 0, 0), Point(1, 0, 0)}};
inline const Case offset_too_long{around_both, two_points, {{0, 1}, Point(1, 0, 0), Point(2, 0, 0)}};
// The ball encloses the points but not the balls about them, or misses one of the balls.
inline const Case ball_of_points{{Point(1, 0, 0), 1}, two_points, extreme.parts};
inline const Case ball_of_one{{Point(0, 0, 0), 1}, two_points, extreme.parts};
inline const Case ball_of_other{{Point(2, 0, 0), 1}, two_points, {{1, 0}, Point(-1, 0, 0), Point(-1, 0, 0)}};

}  // namespace proptests::s44_sum
