// SPDX-License-Identifier: GPL-3.0-or-later
// Draws curves with bounds: cubics by what they are at their ends, and moments of anything that moves within bounds.
#pragma once

#include "lemmas/c1_chord_bound.hpp"
#include "proptests/gen/quaternion.hpp"

namespace proptests::gen {

using RationalMotion = refitlab::Motion<Rational>;

// Draws a vector of R^3 of the length 1.
inline RationalVec<3> unit_direction() { return refitlab::rotate<Rational>(*unit_quaternion(), RationalVec<3>(1, 0, 0)); }

// Returns the cubic with these ends and these second derivatives there.
inline refitlab::CubicCurve<Rational, 3> cubic_between(const RationalVec<3>& from, const RationalVec<3>& to,
                                                       const RationalVec<3>& start, const RationalVec<3>& end,
                                                       const Rational& duration) {
  const RationalVec<3> third = (to - from) / Rational(3);
  const Rational scale = duration * duration / Rational(18);
  return {{from, RationalVec<3>(from + third - (start * Rational(2) + end) * scale),
           RationalVec<3>(to - third - (start + end * Rational(2)) * scale), to},
          duration};
}

struct BoundedCurve {
  refitlab::CubicCurve<Rational, 3> curve;
  Rational acceleration, share;
  bool is_parabola, is_line;
};

// Draws a curve whose bound is reached at one end or at both.
inline BoundedCurve bounded_curve() {
  BoundedCurve out;
  out.acceleration = *rational();
  if (out.acceleration < 0) out.acceleration = -out.acceleration;
  const RationalVec<3> start = unit_direction() * out.acceleration;
  out.is_parabola = *rc::gen::inRange(0, 3) == 0;
  const RationalVec<3> end =
      out.is_parabola ? start : RationalVec<3>(unit_direction() * Rational(out.acceleration * *unit_interval_rational()));
  out.is_line = out.acceleration == 0;
  out.curve = cubic_between(*rational_vector<3>(), *rational_vector<3>(), start, end, *positive_rational());
  out.share = *unit_interval_rational();
  return out;
}

// Draws a moment that is within the bounds, and often at them. Its value has D dimensions.
template <int D>
refitlab::Moment<Rational, D> moment_within(const RationalMotion& m) {
  const auto part = [](const Rational& length) {
    RationalVec<D> v = *rational_vector<D>();
    const Rational squared = refitlab::squared_norm<Rational, D>(v);
    // It is along an axis, of exactly this length.
    if (*rc::gen::inRange(0, 2) == 0 || squared == 0) {
      v = RationalVec<D>::Zero();
      v[*rc::gen::inRange(0, D)] = length;
      return v;
    }
    return RationalVec<D>(v * Rational(length * *unit_interval_rational() / (Rational(1) + squared)));
  };
  return {part(m.size), part(m.speed), part(m.acceleration)};
}

inline RationalMotion any_motion() {
  const auto length = [] {
    const Rational x = *rational();
    return x < 0 ? Rational(-x) : x;
  };
  return {length(), length(), length()};
}

// Returns a quaternion of length 1 that turns with the given first and second derivatives along its sphere: the moment of a slerp
// if bend is 0.
inline refitlab::Moment<Rational, 4> turning_moment(const RationalQuaternion& q, const RationalVec<3>& spin,
                                                    const RationalVec<3>& bend) {
  // For pure u and b, q' = u q and q'' = (u u + b) q.
  const auto pure = [](const RationalVec<3>& x) { return RationalQuaternion(Rational(0), x[0], x[1], x[2]); };
  const RationalQuaternion u = pure(spin), rate = refitlab::multiply<Rational>(u, u) + pure(bend);
  return {q, refitlab::multiply<Rational>(u, q), refitlab::multiply<Rational>(rate, q)};
}

}  // namespace proptests::gen
