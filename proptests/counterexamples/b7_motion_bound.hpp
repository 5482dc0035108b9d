// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b7_motion_bound: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/b7_motion_bound.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b7 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Transform = refitlab::RigidTransform<Q>;
using Transforms = std::vector<Transform>;

inline const Point origin(0, 0, 0), y_axis(0, 1, 0);
inline const refitlab::Quaternion<Q> identity(1, 0, 0, 0);
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)}, beyond_the_first{11, -10};

// A joint turns by 33 degrees about the x axis, with the sign that takes the long way round: half-way y is at -y, as far as can
// be from the two images, which are close together.
inline const Transforms long_way{{identity, origin}, {{Q(-24, 25), Q(7, 25), 0, 0}, origin}};
inline const Q short_cosine(24, 25);
inline const Transforms short_way{{identity, origin}, {{short_cosine, Q(7, 25), 0, 0}, origin}};
// The second outweighs the first, whatever the weights.
inline const Transforms unequal{{identity, origin}, {{Q(2400, 25), Q(700, 25), 0, 0}, origin}};
// Nothing moves the origin, but a rotation center elsewhere makes it move.
inline const Point elsewhere(0, 10, 0);

}  // namespace proptests::b7
