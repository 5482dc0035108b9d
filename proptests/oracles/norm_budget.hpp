// SPDX-License-Identifier: GPL-3.0-or-later
// NormBudget is a number type that derives rounding budgets. It carries no value, but a bound on what a kernel's own templates
// can make of all inputs in a range, and a bound on how far floats may be from it.
//
// A number is a scalar, or a coordinate of a vector. `most` bounds the exact scalar, or the length of the exact vector; `error`
// bounds how far the computed one is from that; `least` is a lower bound of an exact positive scalar, or 0. These stay bounds of
// lengths as long as all coordinates of a vector are computed alike: || a + b || <= || a || + || b ||, and || s a || and the
// length of the coordinates' products are at most the products of the lengths. Sums of products that have a better bound than
// that have rules of their own below: dot products, cross products and products of quaternions, whose partial sums are bounded by
// Cauchy and Schwarz, and rotations. Terms of all orders are counted. Underflow and overflow are not: the kernels exclude them by
// ranges and by allowances of their own.
//
// A NormBudget of level 0 uses all rules. The rules for rotations take their errors from the code's own templates at level 1,
// which has the rules of products alone.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/vocabulary/rigid.hpp"

namespace proptests::oracle {

template <int level>
struct NormBudget {
  static constexpr double u = 0x1p-24;  // of floats
  // Comparisons return this answer, which decides which of two branches is taken.
  static inline bool answer = true;
  // This is the error of numbers that are read from memory, in u: those that were rounded to float have 1.
  static inline double input_error = 1;
  // This is added to the error of numbers that are read from here, whatever they are.
  static inline const float *added_begin = nullptr, *added_end = nullptr;
  static inline double added_error = 0;

  // No exact sum is longer than this, by what is known of the kernel's inputs.
  static inline double longest = HUGE_VAL;
  // No exact squared length of a quaternion is less than this.
  static inline double least_squared_norm = 0;

  double most = 0, error = 0, least = 0;
  // Says whether it is a difference of two vectors of the same bound, or a share of one. All shares of a sum add up to at most
  // one, so that adding one keeps the bound.
  bool is_step = false;
  // A cross product has a name, and is perpendicular to its second factor. Lengths of vectors that are perpendicular to each
  // other add up by Pythagoras.
  int name = 0, perpendicular_to = 0;

  NormBudget() = default;
  // Makes a constant, or infinity for an empty box.
  NormBudget(double exact)  // NOLINT: as doubles convert to any number type
      : most(std::isfinite(exact) ? std::abs(exact) : 0),
        least(std::isfinite(exact) ? std::max(exact, 0.0) : 0) {}
  NormBudget(double m, double e, double l) : most(m), error(e), least(l) {}
  // Reads a pack from memory.
  template <class Flags>
  NormBudget(const float* number, Flags) : most(*number),
                                           error(input_error * u * most) {
    if (number >= added_begin && number < added_end) error += added_error * u;
  }
  template <int other>
  explicit NormBudget(const NormBudget<other>& n) : most(n.most),
                                                    error(n.error),
                                                    least(n.least),
                                                    is_step(n.is_step) {}

  using mask_type = bool;
  static constexpr std::size_t size() { return 4; }

  // Adds a rounding: what is computed is at most so long.
  NormBudget rounded() const {
    NormBudget out = *this;
    out.error += u * (most + error);
    return out;
  }
  NormBudget at_most(double length) const { return {std::min(most, length), error, least}; }
  NormBudget at_least(double number) const { return {most, error, std::max(least, number)}; }
  double in_u() const { return error / u; }

  NormBudget operator-() const {
    NormBudget out = *this;
    out.least = 0;
    return out;
  }
  NormBudget operator+(const NormBudget& b) const {
    if (most + error == 0) return b;
    if (b.most + b.error == 0) return *this;
    const bool is_right = (name && name == b.perpendicular_to) || (b.name && b.name == perpendicular_to);
    double length = is_right ? std::hypot(most, b.most) : most + b.most;
    if (is_step != b.is_step) length = is_step ? b.most : most;
    const double both = least > 0 && b.least > 0 ? least + b.least : 0;
    return NormBudget(std::min(length, longest), error + b.error, both).rounded();
  }
  NormBudget operator-(const NormBudget& b) const {
    if (!(least > 0 && b.least > 0)) return *this + -b;
    // This bounds a difference of positive scalars.
    const double length = std::max(most - b.least, b.most - least);
    return NormBudget(length, error + b.error, std::max(least - b.most, 0.0)).rounded();
  }
  NormBudget operator*(const NormBudget& b) const {
    NormBudget exact(most * b.most, most * b.error + error * b.most + error * b.error, least * b.least);
    exact.is_step = is_step || b.is_step;
    exact.name = name ? name : b.name, exact.perpendicular_to = name ? perpendicular_to : b.perpendicular_to;
    return is_power_of_two() || b.is_power_of_two() ? exact : exact.rounded();
  }
  // Says whether products and quotients by it are exact.
  bool is_power_of_two() const {
    int exponent;
    return error == 0 && (most == 0 || (least == most && std::frexp(most, &exponent) == 0.5));
  }
  // Divides by a positive number whose lower bound is known.
  NormBudget operator/(const NormBudget& b) const {
    if (b.is_power_of_two() && b.most > 0) return *this * NormBudget(1 / b.most);
    const double nearest = b.least - b.error;
    if (!(nearest > 0)) return {HUGE_VAL, HUGE_VAL, 0};
    const double quotient = most / b.least;
    const NormBudget exact(quotient, (error + quotient * b.error) / nearest, least / b.most);
    return exact.rounded();
  }
  NormBudget& operator+=(const NormBudget& b) { return *this = *this + b; }
  NormBudget& operator-=(const NormBudget& b) { return *this = *this - b; }
  NormBudget& operator*=(const NormBudget& b) { return *this = *this * b; }

  friend bool operator>(const NormBudget&, const NormBudget&) { return answer; }
  friend bool operator<(const NormBudget&, const NormBudget&) { return !answer; }
  friend bool operator>=(const NormBudget&, const NormBudget&) { return answer; }
  friend bool operator<=(const NormBudget&, const NormBudget&) { return true; }
  friend bool operator==(const NormBudget&, const NormBudget&) { return false; }
  friend NormBudget abs(const NormBudget& a) { return a; }
  static NormBudget greater_of(const NormBudget& a, const NormBudget& b) {
    return {std::max(a.most, b.most), std::max(a.error, b.error), std::max(a.least, b.least)};
  }
  static NormBudget less_of(const NormBudget& a, const NormBudget& b) {
    const bool are_positive = a.least > 0 && b.least > 0;
    return {are_positive ? std::min(a.most, b.most) : std::max(a.most, b.most), std::max(a.error, b.error),
            std::min(a.least, b.least)};
  }
  static NormBudget root_of(const NormBudget& a) {
    // | sqrt x - sqrt y | is | x - y | / (sqrt x + sqrt y), and at most the root of | x - y |.
    const double smaller = std::sqrt(a.least) + std::sqrt(std::max(a.least - a.error, 0.0));
    const double error = std::min(std::sqrt(a.error), smaller > 0 ? a.error / smaller : HUGE_VAL);
    return NormBudget(std::sqrt(a.most), error, std::sqrt(a.least)).rounded();
  }
  friend NormBudget max(const NormBudget& a, const NormBudget& b) { return greater_of(a, b); }
};

using Budget = NormBudget<0>;
using PlainBudget = NormBudget<1>;

// A kernel has checked that the W_kk and W_kl by which it divides are at least these.
inline double least_own_weight = 0, least_mixed_weight = 0;

template <int level, int D>
refitlab::Vec<NormBudget<level>, D> of_length(double most, double error = 0) {
  return refitlab::Vec<NormBudget<level>, D>::Constant(NormBudget<level>(most, error, 0));
}
// Returns the bound of a vector. All of its coordinates have the same bounds; this is the greatest, if they were computed in
// different ways.
template <class Vector>
auto whole(const Vector& v) {
  auto out = v[0];
  for (int i = 1; i < v.size(); ++i) out = max(out, v[i]);
  return out;
}

// Returns the length of a vector whose first coordinate, the real part of a quaternion, may have a bound of its own.
template <int level, int D>
NormBudget<level> length_of(const refitlab::Vec<NormBudget<level>, D>& v) {
  auto out = whole(v);
  if (D == 4 && v[0].most != v[1].most) out.most = std::hypot(v[0].most, v[1].most);
  return out;
}

// Returns a dot product. It has products whose rounding errors add up to u ||a|| ||b||, and partial sums that are at most ||a||
// ||b||.
template <int level, int D>
NormBudget<level> dot_of(const refitlab::Vec<NormBudget<level>, D>& a, const refitlab::Vec<NormBudget<level>, D>& b) {
  const auto x = length_of(a), y = length_of(b);
  const double exact = x.most * y.error + x.error * y.most + x.error * y.error;
  const double computed = (x.most + x.error) * (y.most + y.error);
  return {x.most * y.most, exact + computed * (std::pow(1 + x.u, D) - 1), 0};
}
// Returns a cross product. The two products of each coordinate have errors of sqrt 2 u ||a|| ||b||, as a vector, and the
// differences one of theirs.
template <int level>
refitlab::Vec<NormBudget<level>, 3> cross_of(const refitlab::Vec<NormBudget<level>, 3>& a,
                                             const refitlab::Vec<NormBudget<level>, 3>& b) {
  const auto x = whole(a), y = whole(b);
  const double u = x.u, exact = x.most * y.error + x.error * y.most + x.error * y.error;
  const double computed = (x.most + x.error) * (y.most + y.error);
  NormBudget<level> out(x.most * y.most, exact + computed * (std::sqrt(2.0) * u * (1 + u) + u), 0);
  static int names = 0;
  out.name = ++names, out.perpendicular_to = y.name;
  return refitlab::Vec<NormBudget<level>, 3>::Constant(out);
}
// Returns a product of quaternions, each coordinate of which is a dot product of four. As a vector, the products have errors of 2
// u ||a|| ||b||, because the matrix of the absolute values of a has a norm of at most sum |a_i| <= 2 ||a||; and so have the three
// sums each.
template <int level>
refitlab::Quaternion<NormBudget<level>> multiply_of(const refitlab::Quaternion<NormBudget<level>>& a,
                                                    const refitlab::Quaternion<NormBudget<level>>& b) {
  const auto x = length_of(a), y = length_of(b);
  const double exact = x.most * y.error + x.error * y.most + x.error * y.error;
  const double computed = (x.most + x.error) * (y.most + y.error);
  return of_length<level, 4>(x.most * y.most, exact + 2 * computed * (std::pow(1 + x.u, 4) - 1));
}

}  // namespace proptests::oracle

template <int level>
struct Eigen::NumTraits<proptests::oracle::NormBudget<level>> : Eigen::GenericNumTraits<proptests::oracle::NormBudget<level>> {
  enum { IsInteger = 0, IsSigned = 1, IsComplex = 0, RequireInitialization = 1, ReadCost = 3, AddCost = 6, MulCost = 9 };
};

namespace proptests::oracle {

// Returns the computed operands of a formula, which are exact for its own errors.
template <int D>
refitlab::Vec<PlainBudget, D> exact(const Budget& operand) {
  return of_length<1, D>(operand.most + operand.error);
}
// Returns what a formula makes of inexact operands: its own errors, and how far exact results are apart.
inline refitlab::Vec<Budget, 3> as_computed(const refitlab::Vec<PlainBudget, 3>& own, double most, double of_operands) {
  return of_length<0, 3>(most, whole(own).error + of_operands);
}

}  // namespace proptests::oracle

namespace refitlab {

template <int level>
struct NumberTraits<proptests::oracle::NormBudget<level>> {
  using S = proptests::oracle::NormBudget<level>;
  using Lane = float;  // as kernels have it
  static S square(const S& x) { return x * x; }
  static S sqrt(const S& x) { return S::root_of(x); }
  static S max(const S& a, const S& b) { return S::greater_of(a, b); }
  static S min(const S& a, const S& b) { return S::less_of(a, b); }
};

// These rules stand in place of the templates that kernels call.
#define PROPTESTS_RULES_OF_PRODUCTS(S)                                               \
  template <>                                                                        \
  inline S dot<S, 3>(const Vec<S, 3>& a, const Vec<S, 3>& b) {                       \
    return proptests::oracle::dot_of(a, b);                                          \
  }                                                                                  \
  template <>                                                                        \
  inline S dot<S, 4>(const Vec<S, 4>& a, const Vec<S, 4>& b) {                       \
    return proptests::oracle::dot_of(a, b);                                          \
  }                                                                                  \
  template <>                                                                        \
  inline S squared_norm<S, 3>(const Vec<S, 3>& a) {                                  \
    return proptests::oracle::dot_of(a, a);                                          \
  }                                                                                  \
  template <>                                                                        \
  inline S squared_norm<S, 4>(const Vec<S, 4>& a) {                                  \
    return proptests::oracle::dot_of(a, a).at_least(S::least_squared_norm);          \
  }                                                                                  \
  template <>                                                                        \
  inline Vec<S, 3> cross<S>(const Vec<S, 3>& a, const Vec<S, 3>& b) {                \
    return proptests::oracle::cross_of(a, b);                                        \
  }                                                                                  \
  template <>                                                                        \
  inline Quaternion<S> multiply<S>(const Quaternion<S>& a, const Quaternion<S>& b) { \
    return proptests::oracle::multiply_of(a, b);                                     \
  }
PROPTESTS_RULES_OF_PRODUCTS(proptests::oracle::NormBudget<0>)
PROPTESTS_RULES_OF_PRODUCTS(proptests::oracle::NormBudget<1>)
#undef PROPTESTS_RULES_OF_PRODUCTS

// A rotation keeps lengths. For a quaternion of unit length, x + 2 (w t + v x t) is q x q* - (||q||^2 - 1) x, so that an error
// of q changes it by at most 2 ((1 + error)^2 - 1) ||x||. The formula's own errors are those for exact operands.
template <>
inline Vec<proptests::oracle::Budget, 3> rotate<proptests::oracle::Budget>(const Quaternion<proptests::oracle::Budget>& unit,
                                                                           const Vec<proptests::oracle::Budget, 3>& x) {
  using namespace proptests::oracle;
  const Budget q = whole(unit), v = whole(x);
  const double e = q.error, of_operands = v.error + 2 * (2 * e + e * e) * (v.most + v.error);
  return as_computed(rotate<PlainBudget>(exact<4>(q), exact<3>(v)), v.most, of_operands);
}
// W_kl is at most ||q_k|| ||q_l||, and P_kl at most ||q_k|| ||q_l|| ||x||, as the mean of two products of quaternions. Both are
// linear in each operand, and so are the formulas' own errors, which are those for lengths of 1. Then no sum in the formulas is
// longer than 1. Let q = (w, v). Of P_kl, the first two terms are w_k w_l x - v_k x (x x v_l), the first three are half of what
// P_kl and its value for w of other signs add up to, and the fourth is half of their difference; and |w_k| ||v_l|| + |w_l|
// ||v_k|| and |w_k w_l| + ||v_k|| ||v_l|| are at most 1, by Cauchy and Schwarz.
template <>
inline MixedPair<proptests::oracle::Budget> mix_rotations<proptests::oracle::Budget>(
    const Quaternion<proptests::oracle::Budget>& a, const Quaternion<proptests::oracle::Budget>& b,
    const Vec<proptests::oracle::Budget, 3>& x) {
  using namespace proptests::oracle;
  const Budget q = whole(a), r = whole(b), v = whole(x);
  PlainBudget::longest = 1;
  const MixedPair<PlainBudget> own = mix_rotations<PlainBudget>(of_length<1, 4>(1), of_length<1, 4>(1), of_length<1, 3>(1));
  PlainBudget::longest = HUGE_VAL;
  const double most = q.most * r.most, computed = (q.most + q.error) * (r.most + r.error), along = v.most + v.error;
  const Budget weight(most, own.weight.error * computed + computed - most, &a == &b ? least_own_weight : least_mixed_weight);
  const double error = whole(own.numerator).error * computed * along + computed * along - most * v.most;
  return {weight, of_length<0, 3>(most * v.most, error)};
}
// Im(d q*) is at most ||d|| ||q||.
template <>
inline Vec<proptests::oracle::Budget, 3> scaled_translation<proptests::oracle::Budget>(
    const Quaternion<proptests::oracle::Budget>& dual, const Quaternion<proptests::oracle::Budget>& rotation) {
  using namespace proptests::oracle;
  const Budget d = whole(dual), q = whole(rotation);
  const double most = d.most * q.most, computed = (d.most + d.error) * (q.most + q.error);
  return as_computed(scaled_translation<PlainBudget>(exact<4>(d), exact<4>(q)), most, computed - most);
}

}  // namespace refitlab
