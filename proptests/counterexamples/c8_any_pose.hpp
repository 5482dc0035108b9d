// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c8_any_pose: an arm, folded in the reference pose.
#pragma once

#include "lemmas/c8_any_pose.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c8 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Link = refitlab::PosedLink<Q>;
using Range = refitlab::LinkRange<Q>;

inline const Point ones(1, 1, 1), twice(2, 2, 2);
inline const refitlab::Quaternion<Q> straight(1, 0, 0, 0), half_turn(0, 0, 0, 1);

// An upper arm and a lower one have the length 1, and the hand is at 1: folded at the elbow the hand is at a distance of 1 from
// the shoulder, and stretched at 3.
inline const Link shoulder{straight, Point(1, 0, 0), ones}, bent_elbow{half_turn, Point(1, 0, 0), ones},
    elbow{straight, Point(1, 0, 0), ones};
inline const Range bone{1, 1};
inline const Point hand(1, 0, 0);

}  // namespace proptests::c8
