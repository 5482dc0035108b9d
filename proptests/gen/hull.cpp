// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/hull.hpp"

namespace proptests::gen {
namespace {

// Draws weights for as many vectors as there are.
template <class T>
rc::Gen<std::pair<std::vector<T>, std::vector<Rational>>> weighted(rc::Gen<std::vector<T>> list) {
  return rc::gen::mapcat(std::move(list), [](const std::vector<T>& values) {
    return rc::gen::pair(rc::gen::just(values), convex_weights(static_cast<int>(values.size())));
  });
}

}  // namespace

template <int D>
rc::Gen<ScaledHull<D>> scaled_hull() {
  return rc::gen::apply(
      [](const std::pair<std::vector<RationalVec<D>>, std::vector<Rational>>& units, std::vector<Rational> lengths, bool cancel) {
        ScaledHull<D> hull{units.first, std::move(lengths), units.second};
        const std::size_t m = hull.vectors.size();
        hull.lengths.resize(m);
        if (cancel && m > 1 && hull.vectors[0] == -hull.vectors[1]) {
          hull.weights.assign(m, Rational(0));
          const Rational sum = hull.lengths[0] + hull.lengths[1];
          hull.weights[0] = hull.lengths[1] / sum;
          hull.weights[1] = hull.lengths[0] / sum;
        }
        for (std::size_t i = 0; i < m; ++i) hull.vectors[i] *= hull.lengths[i];
        return hull;
      },
      weighted(sphere_points<D>(1, 4)), rc::gen::container<std::vector<Rational>>(4, positive_rational()),
      rc::gen::arbitrary<bool>());
}

template <int D>
rc::Gen<EnclosedHull<D>> enclosed_hull() {
  const auto slack = rc::gen::weightedOneOf<Rational>({{1, rc::gen::just(Rational(0))}, {1, unit_interval_rational()}});
  return rc::gen::apply(
      [](const std::pair<std::vector<RationalVec<D>>, std::vector<Rational>>& units, RationalVec<D> center, const Rational& more,
         int kind) {
        // This is the mean ball of Algorithm 1.
        if (kind < 3) {
          center = RationalVec<D>::Zero();
          for (const auto& n : units.first) center += n;
          center /= Rational(static_cast<int>(units.first.size()));
        }
        Rational square(0);
        for (const auto& n : units.first) square = refitlab::max_of(square, refitlab::squared_distance(n, center));
        return EnclosedHull<D>{{center, square + more}, units.first, units.second};
      },
      weighted(sphere_points<D>(1, 4)), rational_vector<D>(), slack, rc::gen::inRange(0, 5));
}

template rc::Gen<ScaledHull<1>> scaled_hull<1>();
template rc::Gen<ScaledHull<2>> scaled_hull<2>();
template rc::Gen<ScaledHull<3>> scaled_hull<3>();
template rc::Gen<ScaledHull<4>> scaled_hull<4>();
template rc::Gen<EnclosedHull<1>> enclosed_hull<1>();
template rc::Gen<EnclosedHull<2>> enclosed_hull<2>();
template rc::Gen<EnclosedHull<3>> enclosed_hull<3>();
template rc::Gen<EnclosedHull<4>> enclosed_hull<4>();

}  // namespace proptests::gen
