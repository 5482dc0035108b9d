// SPDX-License-Identifier: GPL-3.0-or-later
// Says whether two quaternions are one rotation, seen by what they do to the coordinate axes.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace proptests {

inline bool rotate_alike(const refitlab::Quaternion<refitlab::Rational>& p, const refitlab::Quaternion<refitlab::Rational>& q) {
  using refitlab::Rational;
  const Rational p2 = refitlab::squared_norm(p), q2 = refitlab::squared_norm(q);
  if (p2 == Rational(0) || q2 == Rational(0)) return false;
  for (int i = 0; i < 3; ++i) {
    refitlab::Vec<Rational, 3> axis = refitlab::Vec<Rational, 3>::Zero();
    axis[i] = 1;
    const refitlab::Vec<Rational, 3> first = refitlab::rotate_scaled(p, axis) / p2;
    if (first != refitlab::Vec<Rational, 3>(refitlab::rotate_scaled(q, axis) / q2)) return false;
  }
  return true;
}

}  // namespace proptests
