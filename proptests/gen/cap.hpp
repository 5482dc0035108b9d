// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational caps in R^d, with any center, often with radius 0 or with an angle of 0, pi/2 or pi, and with points of the cap
// and of its rim.
#pragma once

#include "proptests/gen/cap_angle.hpp"
#include "proptests/gen/sphere_point.hpp"

namespace proptests::gen {

// Holds a cap, and what is needed for a point of its rim without roots. d >= 2.
template <int D>
struct RimmedCap {
  refitlab::Cap<Rational, D> cap;
  Rational sine;  // of the cap's angle
  // It is perpendicular to apex - center and as long.
  RationalVec<D> rim_direction;
};
template <int D>
rc::Gen<RimmedCap<D>> rimmed_cap();

// Holds a cap and a point of it, which is often the apex. d >= 1.
template <int D>
struct CapPoint {
  refitlab::Cap<Rational, D> cap;
  RationalVec<D> point;
};
template <int D>
rc::Gen<CapPoint<D>> cap_point();

template <int D>
void showValue(const RimmedCap<D>& c, std::ostream& out) {
  rc::show(c.cap, out);
  out << ", sine ";
  rc::show(c.sine, out);
  out << ", rim direction ";
  rc::show(c.rim_direction, out);
}

template <int D>
void showValue(const CapPoint<D>& c, std::ostream& out) {
  rc::show(c.cap, out);
  out << " with the point ";
  rc::show(c.point, out);
}

}  // namespace proptests::gen
