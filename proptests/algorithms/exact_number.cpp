// SPDX-License-Identifier: GPL-3.0-or-later
// Tests numbers without rounding: sums, differences and products of any doubles have the sign that rationals give them.
#include "algorithms/runtime/collide/exact_number.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "lemmas/exact/exact.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"

namespace proptests::suite_exact_number {
namespace {

using namespace refitlab;

int sign_of(const Rational& x) { return CGAL::sign(x); }

// Returns any finite double by its bits: denormals, powers of two, numbers near each other and far apart.
double any_double(std::mt19937_64& random) {
  static constexpr double special[] = {0.0,    -0.0,    1.0,           -1.0, 0x1p-1074, 0x1p-1022, 0x1.fffffffffffffp1023,
                                       0x1p32, 0x1p-32, 0x1.00000001p0};
  if (random() % 4 == 0) return special[random() % std::size(special)];
  if (random() % 2 == 0)
    return std::ldexp(static_cast<double>(static_cast<int>(random() % 2001) - 1000), static_cast<int>(random() % 8) * 16 - 64);
  const double x = std::bit_cast<double>(random());
  return std::isfinite(x) ? x : 1.5;
}

}  // namespace

PROPTEST(exact_number) {
  t.example("sums of products of any doubles, and their differences from each other, have the signs of rationals",
            {.number_type = "exact"}, [] {
              std::mt19937_64 random(Session::get().seed());
              constexpr long cases = 20000;
              long zeros = 0;
              for (long i = 0; i < cases; ++i) {
                const double a = any_double(random), b = any_double(random), c = any_double(random), d = any_double(random);
                const ExactNumber sum = ExactNumber(a) * ExactNumber(b) + ExactNumber(c) * ExactNumber(d),
                                  difference = ExactNumber(a) - ExactNumber(b) * ExactNumber(c);
                const Rational p(a), q(b), r(c), s(d);
                if (sum.sign() != sign_of(p * q + r * s) || difference.sign() != sign_of(p - q * r) || (sum - sum).sign() != 0 ||
                    (sum * difference).sign() != sum.sign() * difference.sign() ||
                    (sum * sum - difference * difference).sign() !=
                        sign_of((p * q + r * s) * (p * q + r * s) - (p - q * r) * (p - q * r)) ||
                    (-sum).sign() != -sum.sign())
                  return Checked(false, i, "case " + std::to_string(i));
                zeros += sum.sign() == 0;
              }
              return Checked(zeros > 100, cases, std::to_string(zeros) + " sums of 0");
            });
  t.example("what double loses is there: a denormal beside the largest number, and a product below all doubles", {}, [] {
    const ExactNumber large(std::numeric_limits<double>::max()), least(std::numeric_limits<double>::denorm_min());
    return (large + least - large).sign() == 1 && (large - least - large).sign() == -1 && (least * least).sign() == 1 &&
           (least * least - least).sign() == -1 && (large * large * large - large * large).sign() == 1;
  });
}

}  // namespace proptests::suite_exact_number
