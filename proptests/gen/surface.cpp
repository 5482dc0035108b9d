// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/surface.hpp"

namespace proptests::gen {
namespace {

// Draws a length, which is 0 in a tenth of the cases.
rc::Gen<Rational> length() {
  return rc::gen::weightedOneOf<Rational>({{1, rc::gen::just(Rational(0))}, {9, positive_rational()}});
}

// Draws the offset of the plane as a share of the radius: a cosine, anything, or nothing to mean "through the point".
rc::Gen<rc::Maybe<Rational>> relative_offset() {
  const auto some = [](const Rational& x) { return rc::Maybe<Rational>(x); };
  const auto cosine = rc::gen::map(cap_angle(), [](const CapAngle& a) { return rc::Maybe<Rational>(a.cosine); });
  return rc::gen::weightedOneOf<rc::Maybe<Rational>>(
      {{2, cosine}, {2, rc::gen::map(rational(), some)}, {1, rc::gen::just(rc::Maybe<Rational>())}});
}

}  // namespace

template <int D>
rc::Gen<SurfaceInHalfSpace<D>> surface_in_half_space() {
  return rc::gen::apply(
      [](const RationalVec<D>& center, const Rational& radius, const RationalVec<D>& u, const Rational& stretch,
         const RationalVec<D>& y, const rc::Maybe<Rational>& relative) {
        const RationalVec<D> normal = u * stretch, point = center + y * radius;
        const Rational offset =
            relative ? Rational(refitlab::dot(center, normal) + radius * stretch * *relative) : refitlab::dot(point, normal);
        const bool has_scale = stretch != Rational(0) && radius != Rational(0);
        return SurfaceInHalfSpace<D>{
            {center, radius * radius}, {normal, offset}, has_scale ? Rational(radius / stretch) : Rational(1), point};
      },
      rational_vector<D>(), length(), sphere_point<D>(), length(), sphere_point<D>(), relative_offset());
}

template <int D>
rc::Gen<SurfaceAndBall<D>> surface_and_ball() {
  return rc::gen::apply(
      [](const RationalVec<D>& a, const Rational& radius, const RationalVec<D>& y, RationalVec<D> b, Rational square, int kind) {
        const RationalVec<D> point = a + y * radius;
        if (kind == 9) b = a;
        if (kind == 8) b = a + y * square;  // the point is the nearest or the farthest one
        if (kind >= 5) square = refitlab::squared_distance(point, b);
        return SurfaceAndBall<D>{{a, radius * radius}, {b, square}, point};
      },
      rational_vector<D>(), length(), sphere_point<D>(), rational_vector<D>(), length(), rc::gen::inRange(0, 10));
}

template rc::Gen<SurfaceInHalfSpace<1>> surface_in_half_space<1>();
template rc::Gen<SurfaceInHalfSpace<2>> surface_in_half_space<2>();
template rc::Gen<SurfaceInHalfSpace<3>> surface_in_half_space<3>();
template rc::Gen<SurfaceInHalfSpace<4>> surface_in_half_space<4>();
template rc::Gen<SurfaceAndBall<1>> surface_and_ball<1>();
template rc::Gen<SurfaceAndBall<2>> surface_and_ball<2>();
template rc::Gen<SurfaceAndBall<3>> surface_and_ball<3>();
template rc::Gen<SurfaceAndBall<4>> surface_and_ball<4>();

}  // namespace proptests::gen
