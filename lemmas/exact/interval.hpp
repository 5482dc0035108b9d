// SPDX-License-Identifier: GPL-3.0-or-later
// Interval is a number type whose values are certain enclosures, so that a comparison holds, fails or stays undecided.
//
// CGAL's Interval_nt<true> sets and restores the rounding mode itself. Compile with -frounding-math and
// -ffp-contract=off (the CMake targets do).
#pragma once

#include <CGAL/Interval_nt.h>

#include "lemmas/vocabulary/numbers.hpp"

namespace refitlab {

using Interval = CGAL::Interval_nt<true>;

inline Verdict verdict_of(CGAL::Uncertain<bool> u) { return u.is_certain() ? verdict_of(u.inf()) : Verdict::undecided; }

template <>
struct NumberTraits<Interval> {
  static Interval square(const Interval& x) { return CGAL::square(x); }
  static Interval sqrt(const Interval& x) { return CGAL::sqrt(x); }
  static Interval max(const Interval& a, const Interval& b) { return {greater(a.inf(), b.inf()), greater(a.sup(), b.sup())}; }
  static Interval min(const Interval& a, const Interval& b) { return -max(-a, -b); }
  static Verdict less_equal(const Interval& a, const Interval& b) { return verdict_of(a <= b); }
  static Verdict less(const Interval& a, const Interval& b) { return verdict_of(a < b); }
  static Verdict equal(const Interval& a, const Interval& b) { return verdict_of(a == b); }
  static bool prefer_less(const Interval& a, const Interval& b) { return a.inf() + a.sup() < b.inf() + b.sup(); }

 private:
  // Returns no number if one of both is none.
  static double greater(double x, double y) { return x < y ? y : y <= x ? x : x + y; }
};

}  // namespace refitlab
