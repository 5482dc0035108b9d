// Points of R^3 and R^4 as two pairs of coordinates, the width that every 64-bit processor multiplies at once.
#pragma once

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

// The vector extensions of GCC and Clang. A template, because a typedef would lose the attribute as an argument.
template <class S>
struct PairOf {
  typedef S Type __attribute__((vector_size(2 * sizeof(S))));
};
template <class S>
using Pair = typename PairOf<S>::Type;

template <class S>
Pair<S> both(S x) {
  return Pair<S>{x, x};
}

// A vector of R^4; one of R^3 has a last coordinate 0, which all operations keep.
template <class S>
struct Quad {
  Pair<S> low, high;

  S operator[](int i) const { return i < 2 ? low[i] : high[i - 2]; }
  friend Quad operator+(const Quad& a, const Quad& b) { return {a.low + b.low, a.high + b.high}; }
  friend Quad operator-(const Quad& a, const Quad& b) { return {a.low - b.low, a.high - b.high}; }
  friend Quad operator*(const Quad& a, S x) { return {a.low * both(x), a.high * both(x)}; }
};

template <class S>
S dot(const Quad<S>& a, const Quad<S>& b) {
  const Pair<S> sum = a.low * b.low + a.high * b.high;
  return sum[0] + sum[1];
}

template <class S>
S squared_norm(const Quad<S>& a) {
  return dot(a, a);
}

template <class S>
Quad<S> quad(const Vec<S, 3>& v) {
  return {Pair<S>{v[0], v[1]}, Pair<S>{v[2], S(0)}};
}

template <class S>
Quad<S> quad(const Vec<S, 4>& v) {
  return {Pair<S>{v[0], v[1]}, Pair<S>{v[2], v[3]}};
}

template <int D, class S>
Vec<S, D> vec(const Quad<S>& q) {
  Vec<S, D> v;
  for (int i = 0; i < D; ++i) v[i] = q[i];
  return v;
}

}  // namespace refitlab
