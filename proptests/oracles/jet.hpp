// SPDX-License-Identifier: GPL-3.0-or-later
// A Jet is a number with its first two derivatives. Any template over a number type, run on jets, differentiates itself exactly:
// an independent way to the derivatives that lemmas bound.
#pragma once

#include <Eigen/Core>

#include "lemmas/vocabulary/motion.hpp"

namespace proptests::oracle {

template <class S>
struct Jet {
  S value{0}, first{0}, second{0};
  Jet() = default;
  Jet(int n) : value(n) {}       // NOLINT: numbers of templates
  Jet(const S& v) : value(v) {}  // NOLINT: constants
  Jet(const S& v, const S& d, const S& dd) : value(v), first(d), second(dd) {}

  friend Jet operator+(const Jet& a, const Jet& b) {
    return {S(a.value + b.value), S(a.first + b.first), S(a.second + b.second)};
  }
  friend Jet operator-(const Jet& a, const Jet& b) {
    return {S(a.value - b.value), S(a.first - b.first), S(a.second - b.second)};
  }
  friend Jet operator-(const Jet& a) { return Jet() - a; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {S(a.value * b.value), S(a.first * b.value + a.value * b.first),
            S(a.second * b.value + S(2) * a.first * b.first + a.value * b.second)};
  }
  friend Jet operator/(const Jet& a, const Jet& b) {
    const S value = a.value / b.value, first = (a.first - value * b.first) / b.value;
    return {value, first, S((a.second - S(2) * first * b.first - value * b.second) / b.value)};
  }
  Jet& operator+=(const Jet& b) { return *this = *this + b; }
  Jet& operator-=(const Jet& b) { return *this = *this - b; }
  Jet& operator*=(const Jet& b) { return *this = *this * b; }
  Jet& operator/=(const Jet& b) { return *this = *this / b; }
  // Comparisons look at the value alone, which is what a program that does not differentiate sees.
  friend bool operator==(const Jet& a, const Jet& b) { return a.value == b.value; }
  friend bool operator<(const Jet& a, const Jet& b) { return a.value < b.value; }
  friend bool operator<=(const Jet& a, const Jet& b) { return a.value <= b.value; }
};

// Converts a moment of a curve to a vector of jets, and back.
template <class S, int D>
refitlab::Vec<Jet<S>, D> jets_of(const refitlab::Moment<S, D>& m) {
  refitlab::Vec<Jet<S>, D> out;
  for (int i = 0; i < D; ++i) out[i] = Jet<S>(m.value[i], m.velocity[i], m.acceleration[i]);
  return out;
}
template <class S, int D>
refitlab::Moment<S, D> moment_of(const refitlab::Vec<Jet<S>, D>& jets) {
  refitlab::Moment<S, D> out;
  for (int i = 0; i < D; ++i) out.value[i] = jets[i].value, out.velocity[i] = jets[i].first, out.acceleration[i] = jets[i].second;
  return out;
}

}  // namespace proptests::oracle

template <class S>
struct Eigen::NumTraits<proptests::oracle::Jet<S>> : Eigen::GenericNumTraits<proptests::oracle::Jet<S>> {
  using Real = proptests::oracle::Jet<S>;
  using NonInteger = Real;
  using Nested = Real;
  enum { IsInteger = 0, IsSigned = 1, IsComplex = 0, RequireInitialization = 1, ReadCost = 6, AddCost = 100, MulCost = 100 };
};
