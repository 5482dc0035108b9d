// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the rotation center as one stacked least-squares problem, by a singular value decomposition.
#pragma once

#include <span>

#include "lemmas/vocabulary/rigid.hpp"

namespace proptests::oracle {

struct RotationCenter {
  Eigen::Vector3d point;
  // This is the rank of the stacked differences of rotations, by the tolerances of rotation_center.hpp.
  int rank;
  // This is the least |log10(singular value / tolerance)|, which is small where rounding may flip the rank.
  double nearest_to_tolerance;
  // This projects on the directions in which any point is a solution.
  Eigen::Matrix3d undetermined;
};

// Returns the minimiser, nearest to prior, of the sum over all pairs of ||C_a r - C_b r||^2.
RotationCenter rotation_center(std::span<const refitlab::RigidTransform<double>> transforms, const Eigen::Vector3d& prior);

// Returns that sum, at r.
double sum_over_pairs(std::span<const refitlab::RigidTransform<double>> transforms, const Eigen::Vector3d& r);

}  // namespace proptests::oracle
