// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c1_chord_bound: what goes wrong without each hypothesis, and what the ends alone do not tell.
#pragma once

#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c1 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 2>;
using Curve = refitlab::CubicCurve<Q, 2>;

inline const Q half(1, 2);

// The curve (t, t^2 - t) over [0, 1] has f'' = (0, 2), and is 1/4 from the chord in the middle, which is 2 h^2 / 8.
inline const Curve parabola{{Point(0, 0), Point(Q(1, 3), Q(-1, 3)), Point(Q(2, 3), Q(-1, 3)), Point(1, 0)}, 1};
inline const Q parabola_bends(2);

// f'' goes from 0 to (0, 6), which is within 6, but not within 1.
inline const Curve late_bend{{Point(0, 0), Point(1, 0), Point(2, 0), Point(3, 1)}, 1};

// The curve |t| over [-1, 1] has no second derivative except at the kink, where f is 1 from its chord. It runs at 1 and so is 2 h
// L / 4 away.
inline const Point kink_start(1, 0), kink_end(1, 0), kink(0, 0);

// The curve jumps from 0 to 1 in the middle of a second, and has no speed at any other time.
inline const Point before_jump(0, 0), after_jump(1, 0);

// The curve is a quarter of the unit circle, from about -45 to 45 degrees: the middle is at 1, and both ends are at 4/5 from the
// y axis.
inline const Point arc_start(Q(4, 5), Q(-3, 5)), arc_end(Q(4, 5), Q(3, 5)), arc_middle(1, 0);

}  // namespace proptests::c1
