// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of lemma3_sphere_surface_intersection: a ball and the unit circle.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"

namespace proptests::lemma3 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 2>;
using Disc = refitlab::SquaredBall<Q, 2>;

inline const Disc unit_circle{Point(0, 0), Q(1)};
inline const Point on_circle(1, 0);

// These have nothing in common with the circle: they are strictly inside, and beyond. The second pair is the smallest.
inline const Disc inside{Point(Q(1, 2), 0), Q(1, 16)}, beyond{Point(3, 0), Q(1, 4)};
inline const Disc point_inside{Point(0, 0), Q(0)}, point_beyond{Point(2, 0), Q(0)};

// With b = a there is no normal, whether the ball holds nothing of the circle or all of it. There is also the division by ||b|| =
// 0.
inline const Disc concentric_small{Point(0, 0), Q(1, 4)}, concentric_large{Point(0, 0), Q(4)};

// With e = -2, 0 is inside H, at the distance 0 and not |e| / 2.
inline const Disc holds_most{Point(1, 0), Q(4)};

// The center of the circle is in this disc but not in H: for points off the circle the two differ.
inline const Disc through_center{Point(1, 0), Q(1)};

}  // namespace proptests::lemma3
