// SPDX-License-Identifier: GPL-3.0-or-later
// A RunningError is a double with a bound of how far it is from what exact arithmetic would have made [Wilkinson 1963], carried
// along operation by operation. It is a number type for the code's own templates: what it reports is derived from the very
// operations that run.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "lemmas/vocabulary/numbers.hpp"

namespace proptests::oracle {

struct RunningError {
  static constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  double value = 0, error = 0;  // |value - exact| <= error, up to the rounding of the bound itself

  RunningError() = default;
  RunningError(double exact) : value(exact) {}  // NOLINT: as doubles convert to any number type
  RunningError(double v, double e) : value(v), error(e) {}

  RunningError operator-() const { return {-value, error}; }
  static RunningError rounded(double v, double e) { return {v, e + u * std::abs(v)}; }
  friend RunningError operator+(const RunningError& a, const RunningError& b) {
    return RunningError::rounded(a.value + b.value, a.error + b.error);
  }
  friend RunningError operator-(const RunningError& a, const RunningError& b) { return a + -b; }
  friend RunningError operator*(const RunningError& a, const RunningError& b) {
    // A product by a power of two is exact.
    const double e = std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
    int exponent;
    const bool is_exact = (a.error == 0 && std::abs(std::frexp(a.value, &exponent)) == 0.5) ||
                          (b.error == 0 && std::abs(std::frexp(b.value, &exponent)) == 0.5);
    return is_exact ? RunningError{a.value * b.value, e} : RunningError::rounded(a.value * b.value, e);
  }
  friend RunningError operator/(const RunningError& a, const RunningError& b) {
    const double q = a.value / b.value;
    return RunningError::rounded(q, (a.error + std::abs(q) * b.error) / (std::abs(b.value) - b.error));
  }
  RunningError& operator+=(const RunningError& b) { return *this = *this + b; }
  RunningError& operator-=(const RunningError& b) { return *this = *this - b; }
  RunningError& operator*=(const RunningError& b) { return *this = *this * b; }
  RunningError& operator/=(const RunningError& b) { return *this = *this / b; }
  friend bool operator<(const RunningError& a, const RunningError& b) { return a.value < b.value; }
  friend bool operator<=(const RunningError& a, const RunningError& b) { return a.value <= b.value; }
  friend bool operator==(const RunningError& a, const RunningError& b) { return a.value == b.value; }
  friend bool operator!=(const RunningError& a, const RunningError& b) { return a.value != b.value; }
  friend bool operator>(const RunningError& a, const RunningError& b) { return a.value > b.value; }
  friend RunningError sqrt(const RunningError& a) {
    const double r = std::sqrt(a.value);
    return RunningError::rounded(r, r > 0 ? a.error / (r + std::sqrt(std::max(0.0, a.value - a.error))) : std::sqrt(a.error));
  }
};

// Returns the length of a vector's errors.
template <class Vector>
double error_length(const Vector& v) {
  double sum = 0;
  for (int i = 0; i < v.size(); ++i) sum += v[i].error * v[i].error;
  return std::sqrt(sum);
}

}  // namespace proptests::oracle

template <>
struct Eigen::NumTraits<proptests::oracle::RunningError> : Eigen::GenericNumTraits<proptests::oracle::RunningError> {
  enum { IsInteger = 0, IsSigned = 1, IsComplex = 0, RequireInitialization = 1, ReadCost = 2, AddCost = 4, MulCost = 6 };
};
