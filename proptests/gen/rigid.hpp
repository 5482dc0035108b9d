// SPDX-License-Identifier: GPL-3.0-or-later
// Rational rigid transforms: a rational unit quaternion and a rational translation.
#pragma once

#include "proptests/gen/quaternion.hpp"

namespace proptests::gen {

using RationalTransform = refitlab::RigidTransform<Rational>;

// The identity, half-turns and pure translations come up often.
rc::Gen<RationalTransform> rigid_transform();
// Between low and high transforms: a joint-set in one pose; a third of the lists repeat one.
rc::Gen<std::vector<RationalTransform>> rigid_transforms(int low, int high);

}  // namespace proptests::gen
