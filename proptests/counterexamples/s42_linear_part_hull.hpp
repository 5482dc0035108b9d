// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s42_linear_part_hull: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s42_linear_part_hull.hpp"

namespace proptests::s42 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;

// Two joints keep the rotation center and move it by (1, 0, 0), and the weights are free.
inline const refitlab::WeightBounds<Q> segment{{0, 0}, {1, 1}};
inline const std::vector<Point> points{Point(0, 0, 0), Point(1, 0, 0)};
inline const std::vector<Q> second{0, 1};
// These bounds admit no weight above 1/2.
inline const refitlab::WeightBounds<Q> halves{{0, 0}, {Q(1, 2), Q(1, 2)}};

// Without the second weight vertex its point is beyond the hull.
inline const refitlab::WeightVertices<Q> first_only{{1, 0}};
inline const Point along_the_points(1, 0, 0);

// With a weight vertex outside W' the hull holds a point that no admissible weights make: (-1, 0, 0).
inline const refitlab::WeightVertices<Q> too_far{{2, -1}, {1, 0}, {0, 1}};
inline const std::vector<Q> only_the_first{1, 0, 0};

}  // namespace proptests::s42
