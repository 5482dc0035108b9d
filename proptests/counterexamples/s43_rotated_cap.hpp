// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s43_rotated_cap: what goes wrong without each hypothesis, and where the paper is wrong.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s43_rotated_cap.hpp"

namespace proptests::s43_cap {

using Q = refitlab::Rational;
using Vector = refitlab::Vec<Q, 3>;
using refitlab::Quaternion;

inline const Quaternion<Q> no_turn(1, 0, 0, 0), half_turn_about_x(0, 1, 0, 0), zero(0, 0, 0, 0);
inline const Vector y(0, 1, 0), twice_y(0, 2, 0), z(0, 0, 1);

// In print, past pi/2 the doubled angle has cosine 2 (-4/5)^2 - 1 = 7/25. But the cap holds a half turn: y moves to -y.
inline const Q past_right_angle(-4, 5);
// This angle is before pi/2, and its doubled angle has the same cosine 7/25. The half turn is not in this cap.
inline const Q before_right_angle(4, 5);

}  // namespace proptests::s43_cap
