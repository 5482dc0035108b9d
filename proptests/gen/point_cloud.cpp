// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/point_cloud.hpp"

#include "proptests/gen/any_place.hpp"
#include "proptests/gen/sphere_point.hpp"

namespace proptests::gen {
namespace {

template <int D>
std::vector<RationalVec<D>> combine(const std::vector<RationalVec<D>>& frame, const std::vector<RationalVec<2>>& steps,
                                    bool flat) {
  std::vector<RationalVec<D>> out;
  for (const auto& s : steps) {
    RationalVec<D> p = frame[0] + frame[1] * s[0];
    if (!flat) p = p + frame[2] * s[1];
    out.push_back(p);
  }
  return out;
}

template <class T>
rc::Gen<std::vector<T>> list(int n, rc::Gen<T> element) {
  return rc::gen::container<std::vector<T>>(n, element);
}

template <int D>
rc::Gen<std::vector<RationalVec<D>>> points(Shape shape, int n) {
  const auto frame = list<RationalVec<D>>(3, rational_vector<D>());
  const auto steps = list<RationalVec<2>>(n, rational_vector<2>());
  switch (shape) {
    case Shape::line:
    case Shape::plane:
      return rc::gen::apply([shape](const auto& f, const auto& s) { return combine<D>(f, s, shape == Shape::line); }, frame,
                            steps);
    case Shape::sphere:
      return rc::gen::apply(
          [](std::vector<RationalVec<D>> p, const RationalVec<D>& center) {
            for (auto& x : p) x = x + center;
            return p;
          },
          list<RationalVec<D>>(n, sphere_point<D>()), rational_vector<D>());
    case Shape::grid:
      return list<RationalVec<D>>(n, rc::gen::map(list<int>(D, between(-1, 2)), [](const auto& c) {
                                    RationalVec<D> x;
                                    for (int i = 0; i < D; ++i) x[i] = c[i];
                                    return x;
                                  }));
    case Shape::repeated:
    case Shape::one_point:
      return rc::gen::apply(
          [shape](std::vector<RationalVec<D>> p) {
            for (std::size_t i = 0; i < p.size(); ++i) p[i] = p[shape == Shape::repeated ? i / 3 : 0];
            return p;
          },
          list<RationalVec<D>>(n, rational_vector<D>()));
    default: return list<RationalVec<D>>(n, rational_vector<D>());
  }
}

}  // namespace

template <int D>
rc::Gen<Cloud<D>> cloud(int most) {
  return rc::gen::mapcat(rc::gen::pair(between<int>(0, shape_count + 5), between<int>(1, most + 1)), [](const auto& choice) {
    const Shape shape = choice.first < shape_count ? static_cast<Shape>(choice.first) : Shape::general;
    return rc::gen::map(points<D>(shape, choice.second), [shape](const auto& p) { return Cloud<D>{shape, p}; });
  });
}

template <int D>
std::vector<refitlab::Vec<double, D>> rounded_cloud(std::mt19937_64& random, Shape shape, int n, double offset) {
  using Point = refitlab::Vec<double, D>;
  std::normal_distribution<double> normal;
  const auto any = [&] {
    Point p;
    for (int i = 0; i < D; ++i) p[i] = normal(random);
    return p;
  };
  const Point base = Point::Constant(offset), first = any(), second = any();
  std::vector<Point> out;
  for (int k = 0; k < n; ++k) {
    Point p = any();
    if (shape == Shape::repeated && k > 0 && random() % 3 > 0) p = out[random() % k] - base;
    if (shape == Shape::line) p = first * (static_cast<double>(random() % 7) * 0.1);
    if (shape == Shape::plane) p = first * normal(random) + second * (static_cast<double>(random() % 5) * 0.3);
    if (shape == Shape::sphere) p = p / refitlab::norm(p);
    if (shape == Shape::grid)
      for (int i = 0; i < D; ++i) p[i] = 0.1 * static_cast<double>(random() % 4);
    if (shape == Shape::one_point) p = first;
    out.push_back(base + p);
  }
  return out;
}

template rc::Gen<Cloud<2>> cloud<2>(int);
template rc::Gen<Cloud<3>> cloud<3>(int);
template rc::Gen<Cloud<4>> cloud<4>(int);
template std::vector<refitlab::Vec<double, 2>> rounded_cloud<2>(std::mt19937_64&, Shape, int, double);
template std::vector<refitlab::Vec<double, 3>> rounded_cloud<3>(std::mt19937_64&, Shape, int, double);
template std::vector<refitlab::Vec<double, 4>> rounded_cloud<4>(std::mt19937_64&, Shape, int, double);

}  // namespace proptests::gen
