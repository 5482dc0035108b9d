// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b8_blend_error: where it is sharp, and what goes wrong without each hypothesis.
#pragma once

#include "lemmas/b8_blend_error.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b8 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;
using Blend = refitlab::BlendedDuals<Q>;
using Error = refitlab::BlendError<Q>;

inline const Rotation still(1, 0, 0, 0), zero(0, 0, 0, 0);
inline const Point across(0, 1, 0);

// This is the nearest to the identity of all quaternions that turn about the x axis by twice the angle of cosine 4/5. A point
// across that axis is carried by exactly as much as the bound allows, 6/5.
inline const Rotation nearest(Q(16, 25), Q(12, 25), 0, 0);
inline const Error of_nearest{Q(3, 5), 0, 0, 1};

// A blend that is half as long turns twice as much by the same error: kappa is 2.
inline const Rotation half(Q(1, 2), 0, 0, 0), half_off(Q(8, 25), Q(6, 25), 0, 0);

// Duals that differ by 1/4 move by 2 kappa times that.
inline const Blend at_rest{half, Rotation(0, Q(1, 2), 0, 0)}, moved{half, Rotation(0, Q(3, 4), 0, 0)};
inline const Error of_moved{0, Q(1, 4), Q(1, 2), 2};

}  // namespace proptests::b8
