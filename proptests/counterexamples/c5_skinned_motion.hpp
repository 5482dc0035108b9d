// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c5_skinned_motion: what blending adds to the motion of joints.
#pragma once

#include "lemmas/c5_skinned_motion.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c5 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Motion = refitlab::Motion<Q>;
using Skin = refitlab::SkinMoment<Q>;

inline const Point zero(0, 0, 0);
inline const refitlab::Moment<Q, 3> at_origin{zero, zero, zero}, at_x{Point(1, 0, 0), zero, zero};
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)};

// These quaternions about z have a blend at halves that is 3/5 long: one turns at 2 radians a second, one is at rest, and one in
// the place of that at rest turns as fast as the first.
inline const refitlab::Moment<Q, 4> ahead{{Q(3, 5), 0, 0, Q(4, 5)}, {Q(-4, 5), 0, 0, Q(3, 5)}, {Q(-3, 5), 0, 0, Q(-4, 5)}},
    behind{{Q(3, 5), 0, 0, Q(-4, 5)}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    along{{Q(3, 5), 0, 0, Q(-4, 5)}, {Q(4, 5), 0, 0, Q(3, 5)}, {Q(-3, 5), 0, 0, Q(4, 5)}};
inline const Motion turning{1, 1, 1}, resting{0, 0, 0};
inline const Q length(3, 5);

}  // namespace proptests::c5
