// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c6_interval_hull: what leaves the hull of the ends.
#pragma once

#include "lemmas/c6_interval_hull.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c6 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Curve = refitlab::CubicCurve<Q, 3>;
using Slab = refitlab::Slab<Q>;

inline const Point x_axis(1, 0, 0), origin(0, 0, 0);

// A hand turns from (4/5, -3/5) to (4/5, 3/5) in a second, by a slerp: half-way it is at (1, 0). It turns by 2 asin(3/5), less
// than 1.288 radians, and bends by less than 1.66.
inline const Point hand_start(Q(4, 5), Q(-3, 5), 0), hand_end(Q(4, 5), Q(3, 5), 0), hand_middle(1, 0, 0);
inline const Slab hand_slab{Q(4, 5), Q(4, 5)};
inline const Q hand_bends(166, 100);

// x = 4 t (1 - t) over [0, 1] is at 0 at both ends and bends by 8.
inline const Curve throw_up{{origin, Point(Q(4, 3), 0, 0), Point(Q(4, 3), 0, 0), origin}, 1};
inline const Slab ground{0, 0};
inline const refitlab::Ball3<Q> at_ground{origin, 0};

}  // namespace proptests::c6
