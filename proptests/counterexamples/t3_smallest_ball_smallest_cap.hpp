// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of t3_smallest_ball_smallest_cap: what goes wrong without each hypothesis, and what the mean ball loses.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/t3_smallest_ball_smallest_cap.hpp"

namespace proptests::t3_smallest {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 2>;

struct Case {
  std::vector<Point> units;
  std::vector<Q> coefficients;  // These are the coefficients of the nearest point.
};

inline const Point x(1, 0), y(0, 1);

// The points have different lengths: the nearest one is x, and the smallest ball of both is about (2, 0).
inline const Case not_units{{x, Point(3, 0)}, {1, 0}};
// The mean of x, x and y is not the nearest point.
inline const Case not_nearest{{x, y}, {Q(2, 3), Q(1, 3)}};
// With 0 in the hull the ball is the unit ball, and the center is no direction.
inline const Case zero_inside{{x, -x}, {Q(1, 2), Q(1, 2)}};

// The mean of x and y makes a cap of cos alpha = 0; with x twice the mean ball's cap has cos alpha = -3/5.
inline const Case once{{x, y}, {Q(1, 2), Q(1, 2)}};
inline const Case twice{{x, x, y}, {Q(1, 4), Q(1, 4), Q(1, 2)}};

}  // namespace proptests::t3_smallest
