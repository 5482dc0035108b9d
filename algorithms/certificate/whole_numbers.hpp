// SPDX-License-Identifier: GPL-3.0-or-later
// The exact numbers of CGAL's linear programs over doubles become fractions.
#pragma once

#include <CGAL/Gmpzf.h>

#include <cstdlib>
#include <span>

#include "lemmas/exact/exact.hpp"

namespace refitlab {

inline Rational as_rational(const CGAL::Gmpzf& x) {
  CGAL::Gmpz power(1);
  mpz_mul_2exp(power.mpz(), power.mpz(), static_cast<mp_bitcnt_t>(std::abs(x.exp())));
  return x.exp() < 0 ? Rational(x.man(), power) : Rational(x.man() * power);
}

// Replaces the numbers by whole numbers in the same proportions, without a common divisor. At least one is not 0. Returns the
// factor.
inline Rational make_whole(std::span<Rational> numbers) {
  CGAL::Gmpz multiple(1), divisor(0);
  for (const Rational& n : numbers) mpz_lcm(multiple.mpz(), multiple.mpz(), n.denominator().mpz());
  for (Rational& n : numbers) {
    n *= multiple;
    mpz_gcd(divisor.mpz(), divisor.mpz(), n.numerator().mpz());
  }
  for (Rational& n : numbers) n /= divisor;
  return Rational(multiple, divisor);
}

}  // namespace refitlab
