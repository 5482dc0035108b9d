// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b4_cap_fallback: what goes wrong without each hypothesis, and that neither bound is inside the other.
#pragma once

#include "lemmas/b4_cap_fallback.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b4 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;
using Fallback = refitlab::CapFallback<Q>;

inline const Point x(0, 1, 0), no_offset(0, 0, 0);
inline const std::vector<Point> at_origin{Point(0, 0, 0), Point(0, 0, 0)};
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)}, second{0, 1}, beyond_the_second{-1, 2};
inline const Rotation identity(1, 0, 0, 0);

// kappa^2 = 1 allows no rotation but the axis itself.
inline const Fallback too_narrow{{identity, Rotation(Q(3, 5), Q(4, 5), 0, 0)}, at_origin, identity, 1};

// kappa^2 = 16/25 fits both squares, but the second weight vertex is behind the axis; half-way the blend is far off.
inline const Fallback behind{{identity, Rotation(Q(-4, 5), Q(3, 5), 0, 0)}, at_origin, identity, Q(16, 25)};

// The cap fits, and weights beyond its weight vertices turn further.
inline const Fallback fitting{{identity, Rotation(Q(4, 5), Q(3, 5), 0, 0)}, at_origin, identity, Q(16, 25)};

// The two are half a turn and more apart, with W < 0, and still ahead of the axis between them: the cap is a bound, but the
// control hull is none.
inline const std::vector<Rotation> wide_pair{Rotation(Q(3, 5), Q(4, 5), 0, 0), Rotation(Q(3, 5), Q(-4, 5), 0, 0)};

// The rotations between the weight vertices are of 65.0 and 90.5 degrees: up to a right angle the control point of degree 2 is in
// the cap's ball, beyond it is not. (x is across the axis of the rotations.)
inline const std::vector<Rotation> below_a_right_angle{Rotation(Q(24, 25), Q(7, 25), 0, 0), Rotation(Q(24, 25), Q(-7, 25), 0, 0)};
inline const std::vector<Rotation> beyond_a_right_angle{Rotation(Q(12, 13), Q(5, 13), 0, 0),
                                                        Rotation(Q(12, 13), Q(-5, 13), 0, 0)};

}  // namespace proptests::b4
