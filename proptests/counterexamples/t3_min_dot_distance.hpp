// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of t3_min_dot_distance: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/t3_min_dot_distance.hpp"

namespace proptests::t3_dot {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 2>;

struct Case {
  std::vector<Point> units;
  Point center;
  Q squared_radius;
};

inline const Point x(1, 0), twice_x(2, 0), zero(0, 0);

// A vector of length 2 is about its half: 1 + 1 - 1 = 1 is not twice (2 x, x) = 2.
inline const Case not_unit{{twice_x}, x, 1};
// One radius is above the largest distance, and one below: the paper's form is 1/2 or 3/2 in place of 1.
inline const Case too_large{{x}, x, 1};
inline const Case too_small{{x}, twice_x, 0};
// For the radius of the nearest unit, the paper's form is 1, and the least dot product is -1.
inline const Case of_the_nearest{{x, -x}, x, 0};
// About 0 both forms divide by 0.
inline const Case about_zero{{x, -x}, zero, 1};

}  // namespace proptests::t3_dot
