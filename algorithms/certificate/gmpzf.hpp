// SPDX-License-Identifier: GPL-3.0-or-later
// The exact numbers of CGAL's linear programs over doubles, as fractions.
#pragma once

#include <CGAL/Gmpzf.h>

#include <cstdlib>

#include "lemmas/exact/exact.hpp"

namespace refitlab {

inline Rational as_rational(const CGAL::Gmpzf& x) {
  CGAL::Gmpz power(1);
  mpz_mul_2exp(power.mpz(), power.mpz(), static_cast<mp_bitcnt_t>(std::abs(x.exp())));
  return x.exp() < 0 ? Rational(x.man(), power) : Rational(x.man() * power);
}

}  // namespace refitlab
