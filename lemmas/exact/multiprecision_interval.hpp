// SPDX-License-Identifier: GPL-3.0-or-later
// A MultiprecisionInterval has ends of 60 decimal digits. It is the middle rung of the precision ladder.
#pragma once

#include <CGAL/Gmpq.h>

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfi.hpp>

#include "lemmas/vocabulary/numbers.hpp"

namespace refitlab {

using MultiprecisionInterval =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<60>, boost::multiprecision::et_off>;

// Compares the ends through MPFI, which is right for infinite ends too; an end that is no number decides nothing.
template <>
struct NumberTraits<MultiprecisionInterval> {
  using S = MultiprecisionInterval;

  static S square(const S& x) {
    S y;
    mpfi_sqr(y.backend().data(), x.backend().data());
    return y;
  }
  // Returns the root of the non-negative part of x, which is no number if there is no such part.
  static S sqrt(const S& x) {
    S y = x;
    if (mpfr_sgn(low(y)) < 0 && mpfr_sgn(high(y)) >= 0) mpfr_set_zero(low(y), 1);
    mpfi_sqrt(y.backend().data(), y.backend().data());
    return y;
  }
  static S max(const S& a, const S& b) {
    S y;
    mpfr_max(low(y), low(a), low(b), MPFR_RNDD);
    mpfr_max(high(y), high(a), high(b), MPFR_RNDU);
    return if_numbers(a, b, y);
  }
  static S min(const S& a, const S& b) {
    S y;
    mpfr_min(low(y), low(a), low(b), MPFR_RNDD);
    mpfr_min(high(y), high(a), high(b), MPFR_RNDU);
    return if_numbers(a, b, y);
  }
  static Verdict less_equal(const S& a, const S& b) {
    return mpfr_lessequal_p(high(a), low(b)) ? Verdict::holds
           : mpfr_greater_p(low(a), high(b)) ? Verdict::fails
                                             : Verdict::undecided;
  }
  static Verdict less(const S& a, const S& b) { return !less_equal(b, a); }
  static Verdict equal(const S& a, const S& b) { return less_equal(a, b) & less_equal(b, a); }
  static bool prefer_less(const S& a, const S& b) { return median(a) < median(b); }

 private:
  // Returns no number if one of both is none, of which mpfr_max and mpfr_min would return the other.
  static S if_numbers(const S& a, const S& b, S y) {
    for (const S* x : {&a, &b})
      if (mpfr_nan_p(low(*x)) || mpfr_nan_p(high(*x))) mpfr_set_nan(low(y)), mpfr_set_nan(high(y));
    return y;
  }
  static mpfr_ptr low(S& x) { return &x.backend().data()->left; }
  static mpfr_ptr high(S& x) { return &x.backend().data()->right; }
  static mpfr_srcptr low(const S& x) { return &x.backend().data()->left; }
  static mpfr_srcptr high(const S& x) { return &x.backend().data()->right; }
};

}  // namespace refitlab
