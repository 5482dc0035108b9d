// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/rigid.hpp"

#include <algorithm>

#include "proptests/gen/list.hpp"

namespace proptests::gen {

rc::Gen<RationalTransform> rigid_transform() {
  return rc::gen::apply(
      [](const RationalQuaternion& q, const RationalVec<3>& t) {
        return RationalTransform{q, t};
      },
      unit_quaternion(), rational_vector<3>());
}

rc::Gen<std::vector<RationalTransform>> rigid_transforms(int low, int high) {
  return list_with_repeats(low, high, rigid_transform());
}

Rational least_cosine(const std::vector<RationalTransform>& transforms) {
  Rational least(1);
  for (std::size_t k = 0; k < transforms.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) least = std::min(least, refitlab::dot(transforms[k].rotation, transforms[l].rotation));
  return least;
}

RationalQuaternion drawn_in(RationalQuaternion q) {
  if (q[0] < 0) q = -q;
  const RationalVec<3> v = refitlab::imaginary(q) / (Rational(2) * (Rational(1) + q[0]));
  const Rational s = refitlab::squared_norm(v), scale = Rational(1) / (Rational(1) + s);
  return {(Rational(1) - s) * scale, Rational(2) * v[0] * scale, Rational(2) * v[1] * scale, Rational(2) * v[2] * scale};
}

void draw_together(std::vector<RationalTransform>& transforms, const Rational& least) {
  while (least_cosine(transforms) < least)
    for (RationalTransform& t : transforms) t.rotation = drawn_in(t.rotation);
}

}  // namespace proptests::gen
