// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/sphere_point.hpp"

#include "proptests/gen/list.hpp"

namespace proptests::gen {

template <int D>
rc::Gen<RationalVec<D>> sphere_point() {
  const auto one_hemisphere =
      rc::gen::map(rc::gen::container<std::vector<Rational>>(D - 1, rational()), inverse_stereographic<D>);
  return rc::gen::apply(
      [](RationalVec<D> x, bool negate, int axis) {
        // About a sixth of the cases are an axis.
        if (axis < 2 * D) {
          x = RationalVec<D>::Zero();
          x[axis / 2] = axis % 2 == 0 ? 1 : -1;
        }
        return negate ? RationalVec<D>(-x) : x;
      },
      one_hemisphere, rc::gen::arbitrary<bool>(), rc::gen::map(rc::gen::inRange(0, 12 * D), [](int i) {
        // Shrinking then leads away from replacing the point.
        return 12 * D - 1 - i;
      }));
}

template <int D>
rc::Gen<std::vector<RationalVec<D>>> sphere_points(int low, int high) {
  return rc::gen::apply(
      [](std::vector<RationalVec<D>> points, int kind) {
        if (kind == 4 && points.size() > 1) points[1] = -points[0];
        return points;
      },
      list_with_repeats(low, high, sphere_point<D>()), rc::gen::inRange(0, 5));
}

template <int D>
rc::Gen<PerpendicularPair<D>> perpendicular_pair() {
  // The reflection I - 2 y y^T / |y|^2 has orthonormal rational columns. The pair is two of them, of either sign.
  return rc::gen::apply(
      [](const RationalVec<D>& y, int i, int step, bool negate) {
        const Rational square = refitlab::squared_norm(y);
        const auto column = [&](int k) {
          RationalVec<D> c = -y * (Rational(2) * y[k] / square);
          c[k] += 1;
          return c;
        };
        const RationalVec<D> second = column((i + step) % D);
        return PerpendicularPair<D>{column(i), negate ? RationalVec<D>(-second) : second};
      },
      nonzero_vector<D>(), rc::gen::inRange(0, D), rc::gen::inRange(1, D), rc::gen::arbitrary<bool>());
}

template rc::Gen<RationalVec<1>> sphere_point<1>();
template rc::Gen<RationalVec<2>> sphere_point<2>();
template rc::Gen<RationalVec<3>> sphere_point<3>();
template rc::Gen<RationalVec<4>> sphere_point<4>();
template rc::Gen<std::vector<RationalVec<1>>> sphere_points<1>(int, int);
template rc::Gen<std::vector<RationalVec<2>>> sphere_points<2>(int, int);
template rc::Gen<std::vector<RationalVec<3>>> sphere_points<3>(int, int);
template rc::Gen<std::vector<RationalVec<4>>> sphere_points<4>(int, int);
template rc::Gen<PerpendicularPair<2>> perpendicular_pair<2>();
template rc::Gen<PerpendicularPair<3>> perpendicular_pair<3>();
template rc::Gen<PerpendicularPair<4>> perpendicular_pair<4>();

}  // namespace proptests::gen
