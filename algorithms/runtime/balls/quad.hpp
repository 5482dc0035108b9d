// SPDX-License-Identifier: MIT
// A Quad is a vector of R^3 or R^4 as two rows of two coordinates, the width that every 64-bit processor multiplies at once.
#pragma once

#include "algorithms/runtime/packs/row.hpp"
#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

// A vector of R^3 has the last coordinate 0, which all operations keep.
template <class S>
struct Quad {
  Row<S, 2> low, high;

  S operator[](int i) const { return i < 2 ? low[i] : high[i - 2]; }
  friend Quad operator+(const Quad& a, const Quad& b) { return {a.low + b.low, a.high + b.high}; }
  friend Quad operator-(const Quad& a, const Quad& b) { return {a.low - b.low, a.high - b.high}; }
  friend Quad operator*(const Quad& a, S x) { return {a.low * x, a.high * x}; }
};

template <class S>
S dot(const Quad<S>& a, const Quad<S>& b) {
  const Row<S, 2> sum = a.low * b.low + a.high * b.high;
  return sum[0] + sum[1];
}

template <class S>
S squared_norm(const Quad<S>& a) {
  return dot(a, a);
}

template <class S>
Quad<S> quad(const Vec<S, 3>& v) {
  return {Row<S, 2>{v[0], v[1]}, Row<S, 2>{v[2], S(0)}};
}

template <class S>
Quad<S> quad(const Vec<S, 4>& v) {
  return {Row<S, 2>{v[0], v[1]}, Row<S, 2>{v[2], v[3]}};
}

template <int D, class S>
Vec<S, D> vec(const Quad<S>& q) {
  Vec<S, D> v;
  for (int i = 0; i < D; ++i) v[i] = q[i];
  return v;
}

}  // namespace refitlab
