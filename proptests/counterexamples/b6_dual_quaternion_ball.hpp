// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned cases of b6_dual_quaternion_ball: what goes wrong without each hypothesis, and that near 0 there is no ball.
#pragma once

#include "lemmas/b6_dual_quaternion_ball.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b6 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;
using Blend = refitlab::DualQuaternionBlend<Q>;

inline const Rotation identity(1, 0, 0, 0), none(0, 0, 0, 0);

// No motion and a translation by (2, 0, 0), of opposite signs: the ball about (1, 0, 0) has the radius 1, and two
// thirds of the way the origin is at (-2, 0, 0). Half-way the blend is 0.
inline const Blend opposite{{identity, Rotation(-1, 0, 0, 0)}, {none, Rotation(0, -1, 0, 0)}, Point(0, 0, 0)};
inline const Point between(1, 0, 0);
// Two signs of no motion: half-way both parts of the blend are 0.
inline const Blend still{{identity, Rotation(-1, 0, 0, 0)}, {none, none}, Point(0, 0, 0)};
inline const std::vector<Q> third{Q(2, 3), Q(1, 3)};

// No motion and a turn by 74 degrees: weights beyond the first weight vertex turn the other way, by 106 degrees.
inline const Blend turning{{identity, Rotation(Q(4, 5), Q(3, 5), 0, 0)}, {none, none}, Point(0, 1, 0)};
inline const std::vector<Q> beyond_the_first{5, -4};

}  // namespace proptests::b6
