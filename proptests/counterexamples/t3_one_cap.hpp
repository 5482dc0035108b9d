// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of t3_one_cap: what goes wrong without each hypothesis.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/t3_one_cap.hpp"

namespace proptests::t3_cap {

using Q = refitlab::Rational;
using refitlab::Quaternion;

struct Case {
  std::vector<Quaternion<Q>> quaternions;
  Quaternion<Q> axis;
  Q squared_cosine;
  std::vector<Q> coefficients;
};

inline const Quaternion<Q> one(1, 0, 0, 0);

// A quaternion is behind the axis: squares do not see the sign of -4/5, and the blend (0, 1/3, 0, 0) is at a right angle to the
// axis.
inline const Case behind{{one, Quaternion<Q>(Q(-4, 5), Q(3, 5), 0, 0)}, one, Q(16, 25), {Q(4, 9), Q(5, 9)}};
// The quaternion behind the axis is by itself: its square is right, but its sign is not.
inline const Case only_behind{behind.quaternions, one, Q(16, 25), {0, 1}};
// One of the quaternions does not have this kappa.
inline const Case too_narrow{{one, Quaternion<Q>(Q(3, 5), Q(4, 5), 0, 0)}, one, Q(16, 25), {0, 1}};
// The coefficients are not convex: the blend is (1, 2, 0, 0), beyond the second quaternion.
inline const Case not_convex{{one, Quaternion<Q>(1, 1, 0, 0)}, one, Q(1, 2), {-1, 2}};
// At a right angle to the axis (kappa = 0) a blend may be 0: it stands for no rotation.
inline const Case right_angles{{Quaternion<Q>(0, 1, 0, 0), Quaternion<Q>(0, -1, 0, 0)}, one, 0, {Q(1, 2), Q(1, 2)}};

}  // namespace proptests::t3_cap
