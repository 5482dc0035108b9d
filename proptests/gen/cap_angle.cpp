// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/cap_angle.hpp"

namespace proptests::gen {

rc::Gen<CapAngle> cap_angle() {
  // (p, q) stands for t = p / q, so that q = 0 is the angle pi.
  const auto from_ratio = [](int p, int q) {
    const Rational square(p * p + q * q);
    return CapAngle{Rational(q * q - p * p) / square, Rational(2 * p * q) / square};
  };
  const auto special = rc::gen::element(CapAngle{1, 0}, CapAngle{0, 1}, CapAngle{-1, 0});
  return rc::gen::weightedOneOf<CapAngle>(
      {{1, special}, {2, rc::gen::apply(from_ratio, small_positive_integer(), small_positive_integer())}});
}

void showValue(const CapAngle& angle, std::ostream& out) {
  out << "angle of cosine ";
  showValue(angle.cosine, out);
  out << " and sine ";
  showValue(angle.sine, out);
}

}  // namespace proptests::gen
