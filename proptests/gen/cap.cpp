// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/cap.hpp"

namespace proptests::gen {
namespace {

// Draws a radius, which is 0 in a tenth of the cases.
rc::Gen<Rational> radius() {
  return rc::gen::weightedOneOf<Rational>({{1, rc::gen::just(Rational(0))}, {9, positive_rational()}});
}

}  // namespace

template <int D>
rc::Gen<RimmedCap<D>> rimmed_cap() {
  return rc::gen::apply(
      [](const RationalVec<D>& center, const PerpendicularPair<D>& frame, const Rational& r, const CapAngle& angle) {
        return RimmedCap<D>{{center, center + frame.first * r, angle.cosine}, angle.sine, frame.second * r};
      },
      rational_vector<D>(), perpendicular_pair<D>(), radius(), cap_angle());
}

template <int D>
rc::Gen<CapPoint<D>> cap_point() {
  return rc::gen::apply(
      [](const RationalVec<D>& center, const RationalVec<D>& u, RationalVec<D> y, const Rational& r, const CapAngle& angle) {
        // A point outside of the cap is mirrored at the plane through the center, and if that does not help, replaced by the
        // apex.
        Rational along = refitlab::dot(u, y);
        if (along < angle.cosine) y -= u * (Rational(2) * along), along = -along;
        if (along < angle.cosine) y = u;
        return CapPoint<D>{{center, center + u * r, angle.cosine}, center + y * r};
      },
      rational_vector<D>(), sphere_point<D>(), sphere_point<D>(), radius(), cap_angle());
}

template rc::Gen<RimmedCap<2>> rimmed_cap<2>();
template rc::Gen<RimmedCap<3>> rimmed_cap<3>();
template rc::Gen<RimmedCap<4>> rimmed_cap<4>();
template rc::Gen<CapPoint<1>> cap_point<1>();
template rc::Gen<CapPoint<2>> cap_point<2>();
template rc::Gen<CapPoint<3>> cap_point<3>();
template rc::Gen<CapPoint<4>> cap_point<4>();

}  // namespace proptests::gen
