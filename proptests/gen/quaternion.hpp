// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational unit quaternions q^2 / |q|^2, and lists of them as a joint-set or its weight vertices have.
#pragma once

#include "proptests/gen/vector.hpp"

namespace proptests::gen {

using RationalQuaternion = refitlab::Quaternion<Rational>;

// Draws a unit quaternion: any rational one is q^2 / |q|^2 of some q. Identity, its negative and half-turns come up often.
rc::Gen<RationalQuaternion> unit_quaternion();
// Draws a unit quaternion times a positive rational. Its length is rational, and an input of some lemmas.
rc::Gen<RationalQuaternion> nonzero_quaternion();
// Draws between low and high unit quaternions. A third of the lists repeat one, and a fifth have an antipodal pair.
rc::Gen<std::vector<RationalQuaternion>> unit_quaternions(int low, int high);

}  // namespace proptests::gen
