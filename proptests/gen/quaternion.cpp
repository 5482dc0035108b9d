// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/quaternion.hpp"

#include "proptests/gen/list.hpp"

namespace proptests::gen {

rc::Gen<RationalQuaternion> unit_quaternion() {
  const auto general = rc::gen::map(rc::gen::container<std::vector<int>>(4, small_integer()), [](const std::vector<int>& c) {
    const RationalQuaternion q(c[0], c[1], c[2], c[3]);
    const Rational square = refitlab::squared_norm(q);
    if (square == Rational(0)) return refitlab::identity_quaternion<Rational>();
    return RationalQuaternion(refitlab::multiply(q, q) / square);
  });
  const auto axis = rc::gen::map(rc::gen::inRange(0, 8), [](int k) {
    RationalQuaternion q = RationalQuaternion::Zero();
    q[k / 2] = k % 2 == 0 ? 1 : -1;
    return q;
  });
  return rc::gen::weightedOneOf<RationalQuaternion>({{1, axis}, {4, general}});
}

rc::Gen<RationalQuaternion> nonzero_quaternion() {
  return rc::gen::apply([](const RationalQuaternion& q, const Rational& k) { return RationalQuaternion(q * k); },
                        unit_quaternion(), positive_rational());
}

rc::Gen<std::vector<RationalQuaternion>> unit_quaternions(int low, int high) {
  return rc::gen::apply(
      [](std::vector<RationalQuaternion> list, int kind) {
        if (kind == 4 && list.size() > 1) list[1] = -list[0];
        return list;
      },
      list_with_repeats(low, high, unit_quaternion()), rc::gen::inRange(0, 5));
}

}  // namespace proptests::gen
