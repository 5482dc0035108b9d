// SPDX-License-Identifier: GPL-3.0-or-later
// Exact number types: Rational decides every statement in + - * /, ExactRoot every statement with square roots too.
//
// ExactRoot can be very slow when two deeply nested roots are equal, so statements are put in squared form and checked
// with Rational wherever that is possible.
#pragma once

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>

#include <sstream>
#include <string>

#include "lemmas/vocabulary/numbers.hpp"

namespace refitlab {

using Rational = CGAL::Gmpq;
using ExactRoot = CORE::Expr;

template <>
struct NumberTraits<ExactRoot> {
  static ExactRoot square(const ExactRoot& x) { return x * x; }
  static ExactRoot sqrt(const ExactRoot& x) { return CORE::sqrt(x); }
  static ExactRoot max(const ExactRoot& a, const ExactRoot& b) { return a < b ? b : a; }
  static ExactRoot min(const ExactRoot& a, const ExactRoot& b) { return b < a ? b : a; }
  static Verdict less_equal(const ExactRoot& a, const ExactRoot& b) { return verdict_of(a <= b); }
  static Verdict less(const ExactRoot& a, const ExactRoot& b) { return verdict_of(a < b); }
  static Verdict equal(const ExactRoot& a, const ExactRoot& b) { return verdict_of(a == b); }
  static bool prefer_less(const ExactRoot& a, const ExactRoot& b) { return a < b; }
};

// Returns a fraction as text, such as "3/5" or "-2".
inline std::string as_text(const Rational& x) {
  std::ostringstream out;
  out << x.numerator();
  if (x.denominator() != 1) out << '/' << x.denominator();
  return out.str();
}

}  // namespace refitlab
