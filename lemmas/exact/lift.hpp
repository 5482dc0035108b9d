// SPDX-License-Identifier: GPL-3.0-or-later
// lift<T>(x): rational data as data of another number type T, value by value.
//
// For an interval type the result is a certain enclosure, for an exact type the same value, for a floating-point type a
// neighbour (the value itself if it has one).
#pragma once

#include <type_traits>
#include <vector>

#include "lemmas/exact/exact.hpp"
#include "lemmas/exact/interval.hpp"
#include "lemmas/exact/multiprecision_interval.hpp"
#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/rigid.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

template <class T>
T lift(const Rational& x) {
  if constexpr (std::is_same_v<T, Rational>) {
    return x;
  } else if constexpr (std::is_same_v<T, ExactRoot>) {
    return ExactRoot(CORE::BigRat(x.mpq()));
  } else if constexpr (std::is_same_v<T, Interval>) {
    return Interval(CGAL::to_interval(x));
  } else if constexpr (std::is_same_v<T, MultiprecisionInterval>) {
    T y;
    mpfi_set_q(y.backend().data(), x.mpq());
    return y;
  } else {
    static_assert(std::is_floating_point_v<T>);
    return static_cast<T>(CGAL::to_double(x));
  }
}

template <class T, int D>
Vec<T, D> lift(const Vec<Rational, D>& v) {
  Vec<T, D> out(v.size());
  for (int i = 0; i < v.size(); ++i) out[i] = lift<T>(v[i]);
  return out;
}

template <class T, int D>
Ball<T, D> lift(const Ball<Rational, D>& ball) {
  return {lift<T>(ball.center), lift<T>(ball.radius)};
}

template <class T, int D>
SquaredBall<T, D> lift(const SquaredBall<Rational, D>& ball) {
  return {lift<T>(ball.center), lift<T>(ball.squared_radius)};
}

template <class T, int D>
HalfSpace<T, D> lift(const HalfSpace<Rational, D>& h) {
  return {lift<T>(h.normal), lift<T>(h.offset)};
}

template <class T, int D>
Cap<T, D> lift(const Cap<Rational, D>& cap) {
  return {lift<T>(cap.center), lift<T>(cap.apex), lift<T>(cap.cos_angle)};
}

template <class T>
RigidTransform<T> lift(const RigidTransform<Rational>& c) {
  return {lift<T>(c.rotation), lift<T>(c.translation)};
}

template <class T, class X>
auto lift(const std::vector<X>& list) {
  std::vector<decltype(lift<T>(list[0]))> out;
  out.reserve(list.size());
  for (const X& x : list) out.push_back(lift<T>(x));
  return out;
}

template <class T>
WeightBounds<T> lift(const WeightBounds<Rational>& bounds) {
  return {lift<T>(bounds.low), lift<T>(bounds.high)};
}

}  // namespace refitlab
