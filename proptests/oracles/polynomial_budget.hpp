// SPDX-License-Identifier: GPL-3.0-or-later
// PolynomialBudget is a number type that derives the rounding budgets of determinants. A number is bounded by polynomials with
// positive coefficients in the largest differences X, Y, Z of the vertices' coordinates, and in e, which is twice the vertices'
// slack. So one run of the code's own templates compares errors with allowances for all X, Y, Z and e, coefficient by
// coefficient.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "lemmas/vocabulary/numbers.hpp"

namespace proptests::oracle {

class Polynomial {
 public:
  using Powers = std::array<int, 4>;  // of X, Y, Z and e

  Polynomial() = default;
  Polynomial(double constant) {  // NOLINT: as doubles convert to any number type
    if (constant != 0) of_[{0, 0, 0, 0}] = constant;
  }
  static Polynomial variable(int which) {
    Powers powers{};
    powers[which] = 1;
    Polynomial out;
    out.of_[powers] = 1;
    return out;
  }
  double at(const Powers& powers) const {
    const auto found = of_.find(powers);
    return found == of_.end() ? 0 : found->second;
  }
  bool is_constant() const { return of_.empty() || (of_.size() == 1 && of_.begin()->first == Powers{}); }
  const std::map<Powers, double>& coefficients() const { return of_; }
  friend Polynomial operator+(Polynomial a, const Polynomial& b) {
    for (const auto& [powers, c] : b.of_) a.of_[powers] += c;
    return a;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial out;
    for (const auto& [p, c] : a.of_)
      for (const auto& [q, d] : b.of_) out.of_[{p[0] + q[0], p[1] + q[1], p[2] + q[2], p[3] + q[3]}] += c * d;
    return out;
  }
  friend bool operator==(const Polynomial& a, const Polynomial& b) { return a.of_ == b.of_; }

 private:
  std::map<Powers, double> of_;
};

// Bounds numbers with a unit roundoff of 2^-digits.
template <int digits>
struct PolynomialBudget {
  static constexpr double u = 1.0 / double(1L << digits);
  // This is the greatest share of the allowance that an error takes in any coefficient, of all determinants that were compared.
  static inline double greatest_share = 0;
  static inline long compared = 0;

  // What is computed is at most `most` and, if it is a sum of positive terms, at least `least`. It is within `error` of the
  // true number. axis is the coordinate of a vertex, and -1 for other numbers.
  Polynomial most, error, least;
  int axis = -1;

  PolynomialBudget() = default;
  PolynomialBudget(double exact) : most(std::abs(exact)), least(std::max(exact, 0.0)) {}  // NOLINT
  PolynomialBudget(Polynomial m, Polynomial e, Polynomial l) : most(std::move(m)), error(std::move(e)), least(std::move(l)) {}
  static PolynomialBudget vertex(int axis) {
    PolynomialBudget out;
    out.axis = axis;
    return out;
  }
  // Returns a computed difference of two vertices' coordinates, which is within a rounding of the true one. Numbers of the slack
  // are exact.
  static PolynomialBudget difference(int axis) {
    const Polynomial x = Polynomial::variable(axis);
    return {x, x * Polynomial(u), x};
  }
  static PolynomialBudget twice_slack() { return {Polynomial::variable(3), {}, Polynomial::variable(3)}; }

  PolynomialBudget operator-() const { return {most, error, {}}; }
  friend PolynomialBudget operator-(const PolynomialBudget& a, const PolynomialBudget& b) {
    if (a.axis >= 0 && a.axis == b.axis) return difference(a.axis);
    PolynomialBudget out = a + -b;
    out.least = {};  // it may cancel
    return out;
  }
  friend PolynomialBudget operator+(const PolynomialBudget& a, const PolynomialBudget& b) {
    if (a.most == Polynomial()) return b;
    const Polynomial sum = a.most + b.most;
    return {sum * Polynomial(1 + u), a.error + b.error + sum * Polynomial(u), (a.least + b.least) * Polynomial(1 - u)};
  }
  friend PolynomialBudget operator*(const PolynomialBudget& a, const PolynomialBudget& b) {
    const Polynomial product = a.most * b.most;
    return {product * Polynomial(1 + u), a.most * b.error + a.error * b.most + a.error * b.error + product * Polynomial(u),
            a.least * b.least * Polynomial(1 - u)};
  }
  friend PolynomialBudget abs(const PolynomialBudget& a) { return a; }
  // A determinant and its allowance are compared.
  friend bool operator>(const PolynomialBudget& determinant, const PolynomialBudget& allowance) {
    // This is a check of ranges.
    if (allowance.most.is_constant()) return true;
    for (const auto& [powers, error] : determinant.error.coefficients())
      greatest_share = std::max(greatest_share, error / allowance.least.at(powers));
    ++compared;
    return true;
  }
  // Answers for maxima, which are of equals or of 0, and for checks of ranges.
  friend bool operator<(const PolynomialBudget& a, const PolynomialBudget& b) {
    return a.most == Polynomial() || b.most.is_constant();
  }
};

}  // namespace proptests::oracle

template <int digits>
struct Eigen::NumTraits<proptests::oracle::PolynomialBudget<digits>>
    : Eigen::GenericNumTraits<proptests::oracle::PolynomialBudget<digits>> {
  enum { IsInteger = 0, IsSigned = 1, IsComplex = 0, RequireInitialization = 1, ReadCost = 99, AddCost = 99, MulCost = 99 };
};
