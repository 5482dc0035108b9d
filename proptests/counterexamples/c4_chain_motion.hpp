// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of c4_chain_motion: a hinge that reaches its bounds, and what each of them is for.
#pragma once

#include "lemmas/c4_chain_motion.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::c4 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Link = refitlab::LinkMoment<Q>;
using LinkMotion = refitlab::LinkMotion<Q>;
using Motion = refitlab::Motion<Q>;

inline const Point zero(0, 0, 0), ones(1, 1, 1);
inline const refitlab::Moment<Q, 3> nowhere{zero, zero, zero}, unscaled{ones, zero, zero};
inline const Motion one{1, 0, 0}, none{0, 0, 0};

// The joint turns about z at 2 radians a second, in R^4 at 1, with the next joint at (1, 0, 0).
inline const refitlab::Moment<Q, 4> turning{{1, 0, 0, 0}, {0, 0, 0, 1}, {-1, 0, 0, 0}};
inline const Motion of_turning{1, 1, 1};
inline const Link hinge{nowhere, turning, unscaled}, bone{{Point(1, 0, 0), zero, zero}, turning, unscaled};
inline const LinkMotion of_hinge{none, of_turning, one}, of_bone{one, of_turning, one};
inline const refitlab::Moment<Q, 3> tip{Point(1, 0, 0), zero, zero};

}  // namespace proptests::c4
