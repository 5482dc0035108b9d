// SPDX-License-Identifier: GPL-3.0-or-later
// Rational unit quaternions q^2 / |q|^2, and lists of them as a joint-set or its weight vertices have.
#pragma once

#include "proptests/gen/vector.hpp"

namespace proptests::gen {

using RationalQuaternion = refitlab::Quaternion<Rational>;

// Any rational unit quaternion is q^2 / |q|^2 of some q. Identity, its negative and half-turns come up often.
rc::Gen<RationalQuaternion> unit_quaternion();
// A unit quaternion times a positive rational: its length is rational, and an input of some lemmas.
rc::Gen<RationalQuaternion> nonzero_quaternion();
// Between low and high unit quaternions; a third of the lists repeat one, a fifth have an antipodal pair.
rc::Gen<std::vector<RationalQuaternion>> unit_quaternions(int low, int high);

}  // namespace proptests::gen
