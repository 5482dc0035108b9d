// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b3_subdivision: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/b3_subdivision.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b3 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;

inline const refitlab::SphericalBlend<Q> edge{
    {Rotation(1, 0, 0, 0), Rotation(Q(3, 5), Q(4, 5), 0, 0)}, {Point(0, 0, 0), Point(1, 0, 0)}, Point(0, 1, 0)};
// These weights are beyond the first weight vertex, and so in neither half.
inline const std::vector<Q> beyond_the_first{2, -1}, halves{Q(1, 2), Q(1, 2)};

// The edge has a size: without any its control points would be on the surface.
inline const refitlab::SimplexSizes<Q> no_size{0, 0, 1, 1};
inline const std::vector<std::size_t> first_twice{0, 0, 1};

// An edge is not the longest: the new one, from its middle, is longer than it.
inline const Rotation a(1, 0, 0, 0), close_to_a(1, Q(1, 10), 0, 0), far_from_a(1, 0, 3, 0);

// One quaternion is short and one is long, with W = -3/20: the middle is still behind the short one.
inline const Rotation small(Q(1, 4), 0, 0, 0), large(Q(-3, 5), Q(4, 5), 0, 0);
// These cancel: the middle is 0.
inline const Rotation one(1, 0, 0, 0), minus_one(-1, 0, 0, 0);

}  // namespace proptests::b3
