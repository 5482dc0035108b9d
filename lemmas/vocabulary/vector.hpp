// SPDX-License-Identifier: MIT
// Vectors of R^d have any number type. The two products that need care are here.
#pragma once

#include <Eigen/Core>

#include "lemmas/vocabulary/numbers.hpp"

namespace refitlab {

template <class S, int D>
using Vec = Eigen::Matrix<S, D, 1>;

// Returns the dot product (a, b). It is written out so that the order of the sum is fixed.
template <class S, int D>
S dot(const Vec<S, D>& a, const Vec<S, D>& b) {
  S sum = a[0] * b[0];
  for (int i = 1; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

// Returns ||a||^2. Eigen's squaredNorm would yield [-1, 1] on an interval [-1, 1], but a square is never negative.
template <class S, int D>
S squared_norm(const Vec<S, D>& a) {
  S sum = sq(a[0]);
  for (int i = 1; i < a.size(); ++i) sum = sum + sq(a[i]);
  return sum;
}

template <class S, int D>
S norm(const Vec<S, D>& a) {
  return root(squared_norm(a));
}

// Returns at least ||x|| and at most 16 % more, without a root, in float or double, if nothing underflows. It is 2 - sqrt 2 times
// the greatest coordinate plus sqrt 2 - 1 times all of them. Both factors are greater by 4e-7 here, which is more than the
// roundings of float take: those of a factor, of a product and of three sums, of 6e-8 each at most.
template <class S>
S upper_norm(const Vec<S, 3>& x) {
  const S a = std::abs(x[0]), b = std::abs(x[1]), c = std::abs(x[2]);
  return S(0.5857869) * max_of(a, max_of(b, c)) + S(0.4142140) * (a + b + c);
}

template <class S, int D>
S squared_distance(const Vec<S, D>& a, const Vec<S, D>& b) {
  return squared_norm<S, D>(a - b);
}

template <class S>
Vec<S, 3> cross(const Vec<S, 3>& a, const Vec<S, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Chooses the first or the second vector, as choose() of numbers does.
template <class Mask, class S, int D>
Vec<S, D> choose(const Mask& first, const Vec<S, D>& a, const Vec<S, D>& b) {
  Vec<S, D> out(a.size());
  for (int i = 0; i < a.size(); ++i) out[i] = choose<Mask, S>(first, a[i], b[i]);
  return out;
}

// Converts a vector to another number type, for example double data to exact rationals.
template <class T, class S, int D>
Vec<T, D> convert(const Vec<S, D>& v) {
  Vec<T, D> out(v.size());
  for (int i = 0; i < v.size(); ++i) out[i] = T(v[i]);
  return out;
}

}  // namespace refitlab
