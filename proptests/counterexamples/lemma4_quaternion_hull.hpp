// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of lemma4_quaternion_hull: a disc and unit vectors of the plane.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"

namespace proptests::lemma4 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 2>;
using Disc = refitlab::SquaredBall<Q, 2>;
using Units = refitlab::VecList<Q, 2>;
using Weights = std::vector<Q>;

inline const Weights halves{Q(1, 2), Q(1, 2)}, quarters{Q(1, 4), Q(1, 4), Q(1, 4), Q(1, 4)}, alone{1};

// The mean disc of three equal vectors and a fourth has r = 6/5 and d_H^2 = 1/325 > 0, a cap that r < 1 throws away.
inline const Units three_and_one{Point(1, 0), Point(1, 0), Point(1, 0), Point(Q(-7, 25), Q(24, 25))};
inline const Disc mean_of_three_and_one{Point(Q(17, 25), Q(6, 25)), Q(36, 25)};

// With r_E = 9 / sqrt(40) > 1 and o = 2 ||c|| d_H = -7/10, alpha is beyond pi, and the radius sin(alpha) of line 15 is negative.
inline const Units three_and_wide{Point(1, 0), Point(1, 0), Point(1, 0), Point(Q(-4, 5), Q(3, 5))};
inline const Disc mean_of_three_and_wide{Point(Q(11, 20), Q(3, 20)), Q(81, 40)};

// Where o < 0 the blend (-3/5, 0) points to (-1, 0), which is outside the disc. As a rotation it is inside: (1, 0).
inline const Units behind{Point(Q(-3, 5), Q(4, 5)), Point(Q(-3, 5), Q(-4, 5))};
inline const Disc around_behind{Point(Q(4, 5), 0), Q(13, 5)};

// This is the same in integers, with o = -2.
inline const Units left_and_down{Point(-1, 0), Point(0, -1)};
inline const Disc around_left_and_down{Point(1, 1), Q(5)};

// Where o = 0 the blend of an antipodal pair is 0.
inline const Units up_and_down{Point(0, 1), Point(0, -1)};
inline const Disc around_up_and_down{Point(1, 0), Q(2)};

// This is no unit vector: its direction is not in the disc that holds it.
inline const Units not_unit{Point(Q(1, 2), Q(1, 2))};
inline const Disc only_not_unit{Point(Q(1, 2), Q(1, 2)), Q(0)};

// This is not in the disc.
inline const Units up{Point(0, 1)};
inline const Disc only_right{Point(1, 0), Q(0)};

// Weights that are not convex lead out of the hull.
inline const Units right_and_up{Point(1, 0), Point(0, 1)};
inline const Disc mean_of_right_and_up{Point(Q(1, 2), Q(1, 2)), Q(1, 2)};
inline const Weights not_convex{2, -1};

}  // namespace proptests::lemma4
