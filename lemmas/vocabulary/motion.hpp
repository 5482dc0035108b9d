// SPDX-License-Identifier: MIT
// A Motion bounds a curve over an interval of its parameter: how long its points are, how fast it is, and how much it bends.
//
// Bounds of curves multiply by the rule of Leibniz, so that what a chain of joints makes of a point is bounded link by link
// without a look at where it is. The parameter is a time in seconds, or a weight; then units are per unit of weight in place of
// per second.
#pragma once

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

// ||f|| <= size, ||f'|| <= speed and ||f''|| <= acceleration throughout the interval; none of them negative.
template <class S>
struct Motion {
  S size, speed, acceleration;
};

// Returns the motion of a constant of this size.
template <class S>
Motion<S> at_rest(const S& size) {
  return {size, S(0), S(0)};
}

template <class S>
Motion<S> operator+(const Motion<S>& a, const Motion<S>& b) {
  return {a.size + b.size, a.speed + b.speed, a.acceleration + b.acceleration};
}

// Returns the motion of a product that is linear in both factors and has ||x y|| <= ||x|| ||y||, such as that of quaternions or
// of a matrix and a vector.
template <class S>
Motion<S> product(const Motion<S>& a, const Motion<S>& b) {
  return {a.size * b.size, a.speed * b.size + a.size * b.speed,
          a.acceleration * b.size + S(2) * a.speed * b.speed + a.size * b.acceleration};
}

// Returns bounds of both curves, and so of every convex combination of them with constant coefficients.
template <class S>
Motion<S> widest(const Motion<S>& a, const Motion<S>& b) {
  return {max_of(a.size, b.size), max_of(a.speed, b.speed), max_of(a.acceleration, b.acceleration)};
}

// A curve has a point and its first two derivatives at one moment.
template <class S, int D>
struct Moment {
  Vec<S, D> value, velocity, acceleration;
};

template <class S, int D>
Moment<S, D> operator+(const Moment<S, D>& a, const Moment<S, D>& b) {
  return {a.value + b.value, a.velocity + b.velocity, a.acceleration + b.acceleration};
}

// Applies the rule of Leibniz to a product that is linear in both factors.
template <class S, int D, int E, class Product>
auto product(const Moment<S, D>& a, const Moment<S, E>& b, const Product& times) {
  using Result = decltype(times(a.value, b.value));
  const Result crossed = times(a.velocity, b.velocity);
  return Moment<S, Result::RowsAtCompileTime>{
      times(a.value, b.value), times(a.velocity, b.value) + times(a.value, b.velocity),
      times(a.acceleration, b.value) + crossed + crossed + times(a.value, b.acceleration)};
}

// All three lengths are within the bounds.
template <class S, int D>
Verdict moves_within(const Moment<S, D>& moment, const Motion<S>& bounds) {
  return less_equal(squared_norm(moment.value), sq(bounds.size)) & less_equal(squared_norm(moment.velocity), sq(bounds.speed)) &
         less_equal(squared_norm(moment.acceleration), sq(bounds.acceleration));
}

template <class S>
Verdict is_motion(const Motion<S>& m) {
  return less_equal(S(0), m.size) & less_equal(S(0), m.speed) & less_equal(S(0), m.acceleration);
}

}  // namespace refitlab
