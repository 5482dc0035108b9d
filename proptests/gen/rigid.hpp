// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational rigid transforms: a rational unit quaternion and a rational translation.
#pragma once

#include "proptests/gen/quaternion.hpp"

namespace proptests::gen {

using RationalTransform = refitlab::RigidTransform<Rational>;

// Draws a rigid transform. The identity, half-turns and pure translations come up often.
rc::Gen<RationalTransform> rigid_transform();
// Draws between low and high transforms: a joint-set in one pose. A third of the lists repeat one.
rc::Gen<std::vector<RationalTransform>> rigid_transforms(int low, int high);

}  // namespace proptests::gen
