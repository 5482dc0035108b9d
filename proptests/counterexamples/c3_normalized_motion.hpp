// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c3_normalized_motion: blends that are short turn fast.
#pragma once

#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c3 {

using Q = refitlab::Rational;
using refitlab::Quaternion;
using Moment = refitlab::Moment<Q, 4>;
using Motion = refitlab::Motion<Q>;

// Half-way between (3/5, 4/5) and (3/5, -4/5) the blend is 3/5 long and passes at 8/5: the quaternion turns at 8/3.
inline const Moment half_way{{Q(3, 5), 0, 0, 0}, {0, Q(8, 5), 0, 0}, {0, 0, 0, 0}};
inline const Motion of_half_way{1, Q(8, 5), 0};
inline const Q length(3, 5);

// This is as near to 0 as one likes.
inline const Moment nearly_zero{{Q(1, 1000), 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}};
inline const Motion of_nearly_zero{1, 1, 0};

// The bend of (i) is at its greatest for y^2 = x^2 / 2, in numbers that are nearly so (7^2 + 5^2 = 74).
inline const Moment greatest_bend{{1, 0, 0, 0}, {5, 7, 0, 0}, {0, 0, 0, 0}};

inline const std::vector<Quaternion<Q>> opposite{{1, 0, 0, 0}, {-1, 0, 0, 0}}, right_angle{{1, 0, 0, 0}, {0, 1, 0, 0}};
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)};

}  // namespace proptests::c3
