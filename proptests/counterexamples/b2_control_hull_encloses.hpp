// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b2_control_hull_encloses: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/b2_control_hull_encloses.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b2 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Rotation = refitlab::Quaternion<Q>;
using Blend = refitlab::SphericalBlend<Q>;

inline const std::vector<Point> at_origin{Point(0, 0, 0), Point(0, 0, 0)};
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)}, beyond_the_first{2, -1};

// With W_12 = -3/5 two control points have the weight -1/15 and lie on the far side, and the image is (0, -3/5, 4/5).
inline const Blend far_apart{{Rotation(1, 0, 0, 0), Rotation(Q(-3, 5), Q(4, 5), 0, 0)}, at_origin, Point(0, 1, 0)};
inline const Point upwards(0, 0, 1);

// With W_12 = -1/4 all control points of degree 3 still have positive weights: they are more than half a turn apart, and there is
// still a hull.
inline const Blend beyond_half_a_turn{{Rotation(1, 0, 0, 0), Rotation(Q(-1, 4), 1, 0, 0)}, at_origin, Point(0, 1, 0)};

// With W_12 = 3/5 there is a proper hull, in z >= 0, and the weights (2, -1) turn the other way.
inline const Blend near{{Rotation(1, 0, 0, 0), Rotation(Q(3, 5), Q(4, 5), 0, 0)}, at_origin, Point(0, 1, 0)};
inline const Point downwards(0, 0, -1);

// A ball of radius 1 rests, and a vertex is not in it.
inline const Blend resting{{Rotation(1, 0, 0, 0)}, {Point(0, 0, 0)}, Point(0, 0, 0)};
inline const std::vector<Q> all{1};
inline const refitlab::Ball3<Q> unit_ball{Point(0, 0, 0), 1};
inline const Point too_long(2, 0, 0);

}  // namespace proptests::b2
