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

// Returns the least dot product of two of their quaternions, or 1 if there are no two.
Rational least_cosine(const std::vector<RationalTransform>& transforms);
// Returns the rotation of half the stereographic parameter, by the shorter way.
RationalQuaternion drawn_in(RationalQuaternion rotation);
// Draws the rotations in until no cosine is below least, which is less than 1.
void draw_together(std::vector<RationalTransform>& transforms, const Rational& least);

}  // namespace proptests::gen
