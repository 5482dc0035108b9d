// SPDX-License-Identifier: GPL-3.0-or-later
// Draws affine maps: rotations behind scales along axes, and any.
#pragma once

#include "lemmas/a1_affine_image.hpp"
#include "proptests/gen/quaternion.hpp"

namespace proptests::gen {

struct RandomAffine {
  refitlab::AffineMap<Rational> map;
  bool at_right_angles;
};
inline RandomAffine affine_map() {
  RandomAffine out;
  out.at_right_angles = *rc::gen::inRange(0, 3) == 0;
  const RationalQuaternion turn = *unit_quaternion();
  for (int j = 0; j < 3; ++j) {
    RationalVec<3> column = RationalVec<3>::Zero();
    column[j] = *rational();
    out.map.columns[static_cast<std::size_t>(j)] =
        out.at_right_angles ? refitlab::rotate<Rational>(turn, column) : *rational_vector<3>();
  }
  out.map.offset = *rational_vector<3>();
  return out;
}

}  // namespace proptests::gen
