// SPDX-License-Identifier: GPL-3.0-or-later
// The rotation center as one stacked least-squares problem, by a singular value decomposition.
#pragma once

#include <span>

#include "lemmas/vocabulary/rigid.hpp"

namespace proptests::oracle {

struct RotationCenter {
  Eigen::Vector3d point;
  int rank;                      // of the stacked differences of rotations, by the tolerances of rotation_center.hpp
  double nearest_to_tolerance;   // the least |log10(singular value / tolerance)|: small where rounding may flip the rank
  Eigen::Matrix3d undetermined;  // the projection on the directions in which any point will do
};

// The minimiser, nearest to prior, of the sum over all pairs of ||C_a r - C_b r||^2.
RotationCenter rotation_center(std::span<const refitlab::RigidTransform<double>> transforms, const Eigen::Vector3d& prior);

// That sum, at r.
double sum_over_pairs(std::span<const refitlab::RigidTransform<double>> transforms, const Eigen::Vector3d& r);

}  // namespace proptests::oracle
