// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of a2_two_phase_skinning: a vertex between a joint that scales and one that does not.
#pragma once

#include "lemmas/a2_two_phase_skinning.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::a2 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Map = refitlab::AffineMap<Q>;

inline const Map same{{Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)}, Point(0, 0, 0)},
    threefold{{Point(3, 0, 0), Point(0, 3, 0), Point(0, 0, 3)}, Point(0, 0, 0)};
inline const std::vector<Map> scales{same, threefold};
inline const Point vertex(1, 0, 0);
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)}, beyond{-1, 2};
inline const refitlab::SquaredBall<Q, 3> reference{Point(0, 0, 0), 1}, around{Point(0, 0, 0), 9};

}  // namespace proptests::a2
