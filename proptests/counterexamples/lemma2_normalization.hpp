// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of lemma2_normalization.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/lemma2_normalization.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace proptests::lemma2 {

using Q = refitlab::Rational;
using Quat = refitlab::Quaternion<Q>;
using Weights = std::vector<Q>;
using Quaternions = refitlab::VecList<Q, 4>;

inline const Quat one(1, 0, 0, 0), i(0, 1, 0, 0);
inline const Weights halves{Q(1, 2), Q(1, 2)}, ones{1, 1};

// The smallest case is that 1 and -1 blend to 0, which is no rotation.
inline const Quaternions antipodal{one, -one};

// This case has no antipodal pair: 3/8 + 2 * 5/16 * (-3/5) = 0.
inline const Quaternions three_around{one, Quat(Q(-3, 5), Q(4, 5), 0, 0), Quat(Q(-3, 5), Q(-4, 5), 0, 0)};
inline const Weights three_ones{1, 1, 1}, cancelling{Q(3, 8), Q(5, 16), Q(5, 16)};

// A negative factor turns a generator round: 1/2 + i/2 is on no ray of the hull of 1/2 and -i.
inline const Quaternions right_angle{one, i};
inline const Weights one_negative{2, -1};

// 0 has no direction of its own. Whatever unit stands in for it, i here, is on no ray of the hull of 0 and 1.
inline const Quaternions with_zero{Quat(0, 0, 0, 0), one}, stand_in{i, one};
inline const Weights zero_and_one{0, 1}, only_first{1, 0};

// Weights that are not convex stay so.
inline const Weights not_convex{2, -1};

}  // namespace proptests::lemma2
