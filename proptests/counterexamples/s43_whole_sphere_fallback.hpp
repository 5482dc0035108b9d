// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s43_whole_sphere_fallback: where the paper is wrong, and what goes wrong without each hypothesis.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s43_whole_sphere_fallback.hpp"

namespace proptests::s43_fallback {

using Q = refitlab::Rational;
using refitlab::Quaternion;

struct Case {
  std::vector<Quaternion<Q>> units;
  Quaternion<Q> center;
  Q squared_radius;
  std::vector<Q> coefficients;
};

inline const Quaternion<Q> one(1, 0, 0, 0);

// In print, r_E >= 1 needs the whole sphere. Here the mean ball has r_E = 6/5, and makes a cap: d_H^2 = 1/325.
inline const Case thrown_away{{one, one, one, Quaternion<Q>(Q(-7, 25), Q(24, 25), 0, 0)},
                              Quaternion<Q>(Q(17, 25), Q(6, 25), 0, 0),
                              Q(36, 25),
                              {Q(1, 2), 0, 0, Q(1, 2)}};
// In print, line 15 has no fallback. The mean ball has r_E^2 = 81/40, so 1 + ||c||^2 - r^2 = -7/10, and the radius is negative.
inline const Case negative_radius{{one, one, one, Quaternion<Q>(Q(-4, 5), Q(3, 5), 0, 0)},
                                  Quaternion<Q>(Q(11, 20), Q(3, 20), 0, 0),
                                  Q(81, 40),
                                  {Q(1, 4), Q(1, 4), Q(1, 4), Q(1, 4)}};
// The mean of a quaternion and its negative is 0: line 12 divides by 0.
inline const Case zero_center{{one, -one}, Quaternion<Q>(0, 0, 0, 0), Q(1), {1, 0}};

// Without r^2 < 1 + ||c||^2, d_H is -3/5, and the mean of both units is opposite to the center.
inline const Case past_half{{Quaternion<Q>(Q(-3, 5), Q(4, 5), 0, 0), Quaternion<Q>(Q(-3, 5), Q(-4, 5), 0, 0)},
                            Quaternion<Q>(Q(4, 5), 0, 0, 0),
                            Q(13, 5),
                            {Q(1, 2), Q(1, 2)}};
// Without unit length, the short one is in the ball, but far from the axis.
inline const Case short_one{{one, Quaternion<Q>(0, Q(1, 10), 0, 0)}, Quaternion<Q>(Q(1, 2), Q(1, 20), 0, 0), Q(101, 400), {0, 1}};
// Without enclosure, the second unit is not in the ball.
inline const Case not_enclosed{{one, Quaternion<Q>(0, 1, 0, 0)}, one, Q(1, 4), {0, 1}};
// Without convex coefficients, the blend is the opposite of a unit.
inline const Case not_convex{{one, one}, one, Q(1, 4), {-1, 0}};

}  // namespace proptests::s43_fallback
