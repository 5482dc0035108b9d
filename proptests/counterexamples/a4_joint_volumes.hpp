// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of a4_joint_volumes: a vertex that a joint at rest has to three quarters, and is pulled along by another.
#pragma once

#include "lemmas/a4_joint_volumes.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::a4 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Volume = refitlab::CarriedVolume<Q>;

inline const Point vertex(0, 0, 0), ahead(1, 0, 0);
inline const std::vector<Q> weights{Q(3, 4), Q(1, 4)};

// Returns two volumes: the vertex is in the volume of the joint at rest, and 4 beside that of the other one, which comes nearer
// by 4.
inline std::vector<Volume> pulled(const Q& growth) {
  refitlab::RigidTransform<Q> at_rest, coming;
  coming.translation = Point(4, 0, 0);
  return {{at_rest, vertex, Q(0), growth}, {coming, Point(-4, 0, 0), Q(4), growth}};
}

}  // namespace proptests::a4
