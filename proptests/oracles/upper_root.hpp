// SPDX-License-Identifier: GPL-3.0-or-later
// Computes a rational number just above a square root, for radii that must be rational and enclose.
#pragma once

#include <gmp.h>

#include "lemmas/exact/exact.hpp"

namespace proptests {

// Returns sqrt(x) itself if it is rational, and otherwise a number above it by less than 2^-40 / the denominator of x. x >= 0.
inline refitlab::Rational upper_root(const refitlab::Rational& x) {
  // The root is sqrt(n / d) = sqrt(n d 4^40) / (2^40 d).
  CGAL::Gmpz product = x.numerator() * x.denominator(), floor, rest;
  mpz_mul_2exp(product.mpz(), product.mpz(), 80);
  mpz_sqrtrem(floor.mpz(), rest.mpz(), product.mpz());
  if (rest != 0) floor += 1;
  CGAL::Gmpz below = x.denominator();
  mpz_mul_2exp(below.mpz(), below.mpz(), 40);
  return {floor, below};
}

}  // namespace proptests
