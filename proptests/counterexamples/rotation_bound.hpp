// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of rotation_bound: what goes wrong where the cap is more than half of S_3.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/rotation_bound.hpp"

namespace proptests::rotation_cap {

using Q = refitlab::Rational;
using refitlab::Quaternion;
using refitlab::Vec;

// With s^2 = 9/10 the formula of a smaller cap says 1 - v = 7/25 and a radius of 24/25. But the blend with the weights 4/9 and
// 5/9 is (0, 1/3, 0, 0), half a turn about x, which takes (0, 1, 0) to (0, -1, 0): 32/25 from (0, 7/25, 0).
inline const std::vector<Quaternion<Q>> wide{{1, 0, 0, 0}, {Q(-4, 5), Q(3, 5), 0, 0}};
inline const Quaternion<Q> apex(1, 0, 0, 0);
inline const std::vector<Q> weights{Q(4, 9), Q(5, 9)};
inline const Vec<Q, 3> x(0, 1, 0);

}  // namespace proptests::rotation_cap
