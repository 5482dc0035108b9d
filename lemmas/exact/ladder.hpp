// SPDX-License-Identifier: GPL-3.0-or-later
// The precision ladder: a statement about rational data is tried with ever more precise numbers until one decides it.
//
// A rung answers or passes the question up; only the last, exact one must answer. So the verdict is that of exact
// arithmetic, mostly at the price of intervals of doubles.
#pragma once

#include "lemmas/exact/lift.hpp"

namespace refitlab {

enum class Rung { interval, multiprecision_interval, exact };

inline const char* name_of(Rung rung) {
  return rung == Rung::interval ? "interval" : rung == Rung::multiprecision_interval ? "multiprecision interval" : "exact";
}

struct Decision {
  Verdict verdict;
  Rung rung;  // the lowest that decided
};

// statement(inputs...) returns a Verdict and must accept the inputs over any number type.
// Exact is Rational, or ExactRoot for a statement that takes roots.
template <class Exact = Rational, class Statement, class... Inputs>
Decision decide(const Statement& statement, const Inputs&... inputs) {
  const Verdict quick = statement(lift<Interval>(inputs)...);
  if (quick != Verdict::undecided) return {quick, Rung::interval};
  const Verdict closer = statement(lift<MultiprecisionInterval>(inputs)...);
  if (closer != Verdict::undecided) return {closer, Rung::multiprecision_interval};
  return {statement(lift<Exact>(inputs)...), Rung::exact};
}

}  // namespace refitlab
