// Rotation centers: the point whose images under a joint-set's transforms lie closest together [Kavan and Zara 2005b].
#pragma once

#include <span>

#include "algorithms/model/model.hpp"

namespace refitlab {

// argmin_r of the sum over all pairs a < b of ||C_a r - C_b r||^2. Where the minimum is not unique (a single joint, equal
// transforms, parallel axes: any point of a line or plane will do), the minimiser nearest to prior. Directions in which
// the rotations differ by less than 1e-3 of their largest difference, or by less than 1e-4 rad, count as undetermined:
// they could only move the center far away for nothing. All points in the reference frame.
Point3 rotation_center(std::span<const RigidTransform<double>> transforms, const Point3& prior);

}  // namespace refitlab
