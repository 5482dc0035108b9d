// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/show.hpp"

namespace CGAL {
void showValue(const Gmpq& x, std::ostream& out) {
  out << x.numerator();
  if (x.denominator() != Gmpz(1)) out << '/' << x.denominator();
}
}  // namespace CGAL

namespace refitlab {
void showValue(const RigidTransform<Rational>& c, std::ostream& out) {
  out << "rotation ";
  showValue(c.rotation, out);
  out << " then translation ";
  showValue(c.translation, out);
}
}  // namespace refitlab
