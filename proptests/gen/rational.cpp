// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/rational.hpp"

namespace proptests::gen {
namespace {

rc::Gen<int> integer_between(int low_at_zero, bool with_sign) {
  return rc::Gen<int>([=](const rc::Random& random, int size) {
    const int bound = 3 + size / 4;
    const int low = with_sign ? -bound : low_at_zero;
    rc::Random source = random;
    const int value = low + static_cast<int>(source.next() % static_cast<unsigned>(bound - low + 1));
    return rc::shrinkable::shrinkRecur(
        value, [=](int x) { return with_sign ? rc::shrink::integral(x) : rc::shrink::towards(x, low_at_zero); });
  });
}

rc::Gen<Rational> fraction(rc::Gen<int> numerator) {
  return rc::gen::apply([](int n, int d) { return Rational(n, d); }, numerator,
                        rc::gen::weightedOneOf<int>({{1, rc::gen::just(1)}, {3, small_positive_integer()}}));
}

}  // namespace

rc::Gen<int> small_integer() { return integer_between(0, true); }
rc::Gen<int> small_positive_integer() { return integer_between(1, false); }

rc::Gen<Rational> rational() {
  return rc::gen::weightedOneOf<Rational>({{1, rc::gen::just(Rational(0))}, {12, fraction(small_integer())}});
}

rc::Gen<Rational> positive_rational() { return fraction(small_positive_integer()); }

rc::Gen<Rational> unit_interval_rational() {
  return rc::gen::apply([](int a, int b) { return a + b == 0 ? Rational(0) : Rational(a, a + b); }, integer_between(0, false),
                        integer_between(0, false));
}

rc::Gen<Rational> nudge() {
  return rc::gen::apply(
      [](int digits, bool negative) {
        Rational x(negative ? -1 : 1);
        for (int i = 0; i < digits; ++i) x /= Rational(10);
        return digits < 10 ? Rational(0) : x;
      },
      rc::gen::weightedOneOf<int>({{1, rc::gen::just(0)}, {2, rc::gen::inRange(10, 50)}, {1, rc::gen::inRange(50, 81)}}),
      rc::gen::arbitrary<bool>());
}

}  // namespace proptests::gen
