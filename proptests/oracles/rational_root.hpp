// SPDX-License-Identifier: GPL-3.0-or-later
// Takes square roots in Rational, for code that takes one on some of its paths only: it returns the root if it is rational, and
// refuses otherwise.
#pragma once

#include <gmp.h>

#include "lemmas/exact/exact.hpp"

struct NoRationalRoot {};

namespace refitlab {
template <>
inline Rational NumberTraits<Rational>::sqrt(const Rational& x) {
  CGAL::Gmpz n, d, rest;
  mpz_sqrtrem(n.mpz(), rest.mpz(), x.numerator().mpz());
  if (rest != 0) throw NoRationalRoot{};
  mpz_sqrtrem(d.mpz(), rest.mpz(), x.denominator().mpz());
  if (rest != 0) throw NoRationalRoot{};
  return {n, d};
}
}  // namespace refitlab
