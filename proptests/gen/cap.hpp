// SPDX-License-Identifier: GPL-3.0-or-later
// Rational caps in R^d: any center, radius 0 and angles 0, pi/2, pi at a good share; with points of the cap and of its
// rim.
#pragma once

#include "proptests/gen/cap_angle.hpp"
#include "proptests/gen/sphere_point.hpp"

namespace proptests::gen {

// A cap, and what is needed for a point of its rim without roots. d >= 2.
template <int D>
struct RimmedCap {
  refitlab::Cap<Rational, D> cap;
  Rational sine;                 // of the cap's angle
  RationalVec<D> rim_direction;  // perpendicular to apex - center and as long
};
template <int D>
rc::Gen<RimmedCap<D>> rimmed_cap();

// A cap and a point of it. d >= 1. The point is often the apex.
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
