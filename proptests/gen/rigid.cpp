// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/rigid.hpp"

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

}  // namespace proptests::gen
