// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of lemma1_cap_definitions, in the plane.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"

namespace proptests::lemma1 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 2>;
using HalfPlane = refitlab::HalfSpace<Q, 2>;
using Circle = refitlab::SquaredBall<Q, 2>;
using Arc = refitlab::Cap<Q, 2>;

inline const Point right(1, 0), left(-1, 0), up_right(Q(4, 5), Q(3, 5));
inline const Circle unit_circle{Point(0, 0), Q(1)};
inline const Circle single_point{Point(0, 0), Q(0)};

// x >= -2 holds the whole circle: |D - (c, d)| = 2 > 1, and no angle has the cosine -2.
inline const HalfPlane holds_all{Point(1, 0), Q(-2)};
// The scalar -1 is non-zero, and turns x >= 0 into x <= 0.
inline const HalfPlane right_half{Point(1, 0), Q(0)};
// With d = 0, {x : 0 >= 0} is the plane, not a half of it, and no scalar stretches d to the length 1.
inline const HalfPlane whole_plane{Point(0, 0), Q(0)};

// x >= 2 misses the circle.
inline const HalfPlane misses{Point(1, 0), Q(2)};
// Stretched by 2, x >= 1/2 gets the apex (2, 0) off the circle.
inline const HalfPlane beyond_a_half{Point(1, 0), Q(1, 2)};

// With r = 0 the apex is the center, and the half-space of the cap has the normal 0.
inline const Arc no_radius{Point(0, 0), Point(0, 0), Q(1)};
// With cos = 2 no point is within the angle.
inline const Arc no_angle{Point(0, 0), Point(1, 0), Q(2)};

}  // namespace proptests::lemma1
