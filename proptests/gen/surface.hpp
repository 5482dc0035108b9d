// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational sphere surfaces of R^d with a half-space, or with a ball, and a point of the surface. d >= 1.
//
// The plane of the half-space and the surface of the ball often pass through the point, or touch the sphere.
#pragma once

#include "lemmas/vocabulary/squared_ball.hpp"
#include "proptests/gen/cap_angle.hpp"
#include "proptests/gen/sphere_point.hpp"

namespace proptests::gen {

// The normal has a rational length, so that its scale to the radius is rational. The half-space holds the whole
// surface, a cap of it, or nothing; the radius and the normal are 0 now and then.
template <int D>
struct SurfaceInHalfSpace {
  refitlab::SquaredBall<Rational, D> surface;
  refitlab::HalfSpace<Rational, D> half_space;
  // This scales the normal to the radius, where there is one, and is 1 otherwise.
  Rational scale;
  RationalVec<D> point;  // of the surface
};
template <int D>
rc::Gen<SurfaceInHalfSpace<D>> surface_in_half_space();

// Center and radius of both are anything; they may be concentric, apart, or one within the other.
template <int D>
struct SurfaceAndBall {
  refitlab::SquaredBall<Rational, D> surface, ball;
  RationalVec<D> point;  // of the surface
};
template <int D>
rc::Gen<SurfaceAndBall<D>> surface_and_ball();

template <int D>
void showValue(const SurfaceInHalfSpace<D>& c, std::ostream& out) {
  out << "surface of the ";
  rc::show(c.surface, out);
  out << ", ";
  rc::show(c.half_space, out);
  out << ", scale ";
  rc::show(c.scale, out);
  out << ", point ";
  rc::show(c.point, out);
}

template <int D>
void showValue(const SurfaceAndBall<D>& c, std::ostream& out) {
  out << "surface of the ";
  rc::show(c.surface, out);
  out << ", ";
  rc::show(c.ball, out);
  out << ", point ";
  rc::show(c.point, out);
}

}  // namespace proptests::gen
