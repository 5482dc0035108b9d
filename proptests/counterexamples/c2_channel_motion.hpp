// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c2_channel_motion: where a channel goes between keys, and what the keys alone would say.
#pragma once

#include "lemmas/c2_channel_motion.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c2 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using refitlab::Quaternion;

// Both keys are 1, both tangents lead above: half-way the scale is 3/2 though no key is more than 1.
inline const Point one(1, 1, 1), up(2, 2, 2), down(-2, -2, -2);

// This is a turn about z by 2 atan(3/4), some 74 degrees, half of it, and the same with the sign that takes the long way.
inline const Quaternion<Q> start(1, 0, 0, 0), end(Q(7, 25), 0, 0, Q(24, 25)), middle(Q(4, 5), 0, 0, Q(3, 5)),
    other_sign(Q(-7, 25), 0, 0, Q(-24, 25));

}  // namespace proptests::c2
