// SPDX-License-Identifier: GPL-3.0-or-later
// The exact numbers of CGAL's linear programs over doubles, as fractions.
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

// The same proportions in whole numbers without a common divisor, and by what the numbers were multiplied. One of them is not 0.
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
