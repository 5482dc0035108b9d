// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b6_dual_quaternion_ball: what goes wrong without each hypothesis, and that near 0 there is no ball.
#pragma once

#include "lemmas/b6_dual_quaternion_ball.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b6 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;
using Blend = refitlab::DualQuaternionBlend<Q>;

inline const Rotation identity(1, 0, 0, 0), none(0, 0, 0, 0);

// One joint does not move, and one is translated by (2, 0, 0), with opposite signs: the ball about (1, 0, 0) has the radius 1,
// and two thirds of the way the origin is at (-2, 0, 0). Half-way the blend is 0.
inline const Blend opposite{{identity, Rotation(-1, 0, 0, 0)}, {none, Rotation(0, -1, 0, 0)}, Point(0, 0, 0)};
inline const Point between(1, 0, 0);
// No motion is written with two signs: half-way both parts of the blend are 0.
inline const Blend still{{identity, Rotation(-1, 0, 0, 0)}, {none, none}, Point(0, 0, 0)};
inline const std::vector<Q> third{Q(2, 3), Q(1, 3)};

// One joint does not move, and one turns by 74 degrees: weights beyond the first weight vertex turn the other way, by 106
// degrees.
inline const Blend turning{{identity, Rotation(Q(4, 5), Q(3, 5), 0, 0)}, {none, none}, Point(0, 1, 0)};
inline const std::vector<Q> beyond_the_first{5, -4};

}  // namespace proptests::b6
