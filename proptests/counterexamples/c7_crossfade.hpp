// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c7_crossfade: what lies between two clips.
#pragma once

#include "lemmas/c7_crossfade.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c7 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using refitlab::Quaternion;
using Slab = refitlab::Slab<Q>;

// A hand at (1, 0, 0) belongs to a joint that one clip turns by 74 degrees to the right, and the other to the left: (7/25,
// -+24/25, 0). Half-way it is at (1, 0, 0), by nlerp and by slerp.
inline const Quaternion<Q> right(Q(4, 5), 0, 0, Q(-3, 5)), left(Q(4, 5), 0, 0, Q(3, 5)),
    left_other_sign(Q(-4, 5), 0, 0, Q(-3, 5));
inline const Q cosine(7, 25), half(1, 2);
inline const Point hand(1, 0, 0);
inline const Slab of_both{Q(7, 25), Q(7, 25)};

// These are opposite, and have no blend at halves.
inline const Quaternion<Q> one(1, 0, 0, 0), opposite(-1, 0, 0, 0);

}  // namespace proptests::c7
