// SPDX-License-Identifier: GPL-3.0-or-later
// Computes slerp by its sines, over any number type that has them: intervals of 60 digits, and jets of those, which differentiate
// it.
#pragma once

#include "lemmas/exact/multiprecision_interval.hpp"
#include "lemmas/vocabulary/quaternion.hpp"
#include "proptests/oracles/jet.hpp"

namespace proptests::oracle {

template <class S>
Jet<S> sin(const Jet<S>& x) {
  const S s = sin(x.value), c = cos(x.value);
  return {s, S(c * x.first), S(c * x.second - s * x.first * x.first)};
}
// Returns the arccosine of |x| < 1. acos' = -1 / sqrt(1 - x^2).
template <class S>
Jet<S> acos(const Jet<S>& x) {
  const S height = S(1) - x.value * x.value, slope = S(-1) / sqrt(height);
  return {S(acos(x.value)), S(slope * x.first), S(slope * (x.second + x.value * x.first * x.first / height))};
}

// Returns a point of the arc from a to b, even if the way to -b is shorter, for unit quaternions that are neither equal nor
// opposite.
template <class S>
refitlab::Quaternion<S> slerp(const refitlab::Quaternion<S>& a, const refitlab::Quaternion<S>& b, const S& share) {
  const S angle = acos(S(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]));
  const S whole = sin(angle), of_a = sin(S((S(1) - share) * angle)) / whole, of_b = sin(S(share * angle)) / whole;
  refitlab::Quaternion<S> out;
  for (int i = 0; i < 4; ++i) out[i] = a[i] * of_a + b[i] * of_b;
  return out;
}

}  // namespace proptests::oracle
