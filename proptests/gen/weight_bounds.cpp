// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/weight_bounds.hpp"

#include <limits>

#include "algorithms/bake/weight_vertices.hpp"
#include "proptests/gen/weights.hpp"

namespace proptests::gen {
namespace {

WeightPolytope with_weight_vertices(const std::vector<RationalWeights>& vertices) {
  RationalBounds bounds{vertices[0], vertices[0]};
  for (const auto& w : vertices)
    for (std::size_t i = 0; i < w.size(); ++i) {
      bounds.low[i] = std::min(bounds.low[i], w[i]);
      bounds.high[i] = std::max(bounds.high[i], w[i]);
    }
  auto weight_vertices = refitlab::enumerate_weight_vertices(bounds, std::numeric_limits<std::size_t>::max());
  return {bounds, std::move(*weight_vertices)};
}

}  // namespace

rc::Gen<WeightPolytope> bounds_of_vertices(int n) {
  const auto vertices = rc::gen::mapcat(
      rc::gen::inRange(1, 5), [n](int t) { return rc::gen::container<std::vector<RationalWeights>>(t, convex_weights(n)); });
  const auto all_of_wn = rc::gen::map(rc::gen::just(n), [](int count) {
    std::vector<RationalWeights> axes(count, RationalWeights(count, Rational(0)));
    for (int i = 0; i < count; ++i) axes[i][i] = 1;
    return axes;
  });
  return rc::gen::map(rc::gen::weightedOneOf<std::vector<RationalWeights>>({{1, all_of_wn}, {6, vertices}}),
                      with_weight_vertices);
}

rc::Gen<WeightPolytope> any_bounds_of_vertices(int most) {
  return rc::gen::mapcat(rc::gen::inRange(1, most + 1), bounds_of_vertices);
}

rc::Gen<RationalBounds> arbitrary_bounds(int most) {
  return rc::gen::mapcat(rc::gen::inRange(1, most + 1), [](int n) {
    const auto side = rc::gen::container<RationalWeights>(n, unit_interval_rational());
    return rc::gen::apply(
        [](const RationalWeights& low, const RationalWeights& high) {
          return RationalBounds{low, high};
        },
        side, side);
  });
}

rc::Gen<RationalWeights> admissible_weights(const RationalBounds& bounds) {
  const auto places = rc::gen::container<RationalWeights>(bounds.low.size(), unit_interval_rational());
  return rc::gen::map(places, [bounds](RationalWeights w) {
    Rational sum(0), reach(0);
    for (std::size_t i = 0; i < w.size(); ++i) {
      w[i] = bounds.low[i] + w[i] * (bounds.high[i] - bounds.low[i]);
      sum += w[i];
    }
    const auto& ends = sum < Rational(1) ? bounds.high : bounds.low;
    for (std::size_t i = 0; i < w.size(); ++i) reach += ends[i] - w[i];
    if (reach == Rational(0)) return w;  // the sum is 1 already
    const Rational step = (Rational(1) - sum) / reach;
    for (std::size_t i = 0; i < w.size(); ++i) w[i] += step * (ends[i] - w[i]);
    return w;
  });
}

void showValue(const WeightPolytope& b, std::ostream& out) {
  rc::show(b.bounds, out);
  out << " with weight vertices ";
  rc::show(b.vertices, out);
}

}  // namespace proptests::gen

namespace refitlab {
void showValue(const WeightBounds<Rational>& bounds, std::ostream& out) {
  out << "bounds from ";
  rc::show(bounds.low, out);
  out << " to ";
  rc::show(bounds.high, out);
}
}  // namespace refitlab
