// SPDX-License-Identifier: GPL-3.0-or-later
// A Chained is a double that knows when it can be there at the earliest, if each operation begins as soon as what it takes is there. It
// is a number type for the library's own templates, so that the chains are those of the operations that run.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "lemmas/vocabulary/numbers.hpp"

namespace refitlab {

// These are the nanoseconds from the beginning of an operation to its result.
struct Latencies {
  double sum = 0, product = 0, quotient = 0, root = 0;
};

// Comparisons take no time, as if the processor had foreseen how each of them ends.
struct Chained {
  static inline Latencies latencies;
  double value = 0, ready = 0;  // in nanoseconds

  Chained() = default;
  Chained(double v) : value(v) {}  // NOLINT: as doubles convert to any number type
  Chained(double v, double r) : value(v), ready(r) {}

  Chained operator-() const { return {-value, ready}; }
  friend Chained operator+(const Chained& a, const Chained& b) { return {a.value + b.value, later(a, b) + latencies.sum}; }
  friend Chained operator-(const Chained& a, const Chained& b) { return a + -b; }
  friend Chained operator*(const Chained& a, const Chained& b) { return {a.value * b.value, later(a, b) + latencies.product}; }
  friend Chained operator/(const Chained& a, const Chained& b) { return {a.value / b.value, later(a, b) + latencies.quotient}; }
  friend Chained sqrt(const Chained& a) { return {std::sqrt(a.value), a.ready + latencies.root}; }
  Chained& operator+=(const Chained& b) { return *this = *this + b; }
  Chained& operator-=(const Chained& b) { return *this = *this - b; }
  Chained& operator*=(const Chained& b) { return *this = *this * b; }
  Chained& operator/=(const Chained& b) { return *this = *this / b; }
  friend bool operator<(const Chained& a, const Chained& b) { return a.value < b.value; }
  friend bool operator<=(const Chained& a, const Chained& b) { return a.value <= b.value; }
  friend bool operator>(const Chained& a, const Chained& b) { return a.value > b.value; }
  friend bool operator==(const Chained& a, const Chained& b) { return a.value == b.value; }
  friend bool operator!=(const Chained& a, const Chained& b) { return a.value != b.value; }

 private:
  static double later(const Chained& a, const Chained& b) { return std::max(a.ready, b.ready); }
};

}  // namespace refitlab

template <>
struct Eigen::NumTraits<refitlab::Chained> : Eigen::GenericNumTraits<refitlab::Chained> {
  enum { IsInteger = 0, IsSigned = 1, IsComplex = 0, RequireInitialization = 1, ReadCost = 1, AddCost = 1, MulCost = 1 };
};
