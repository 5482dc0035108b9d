// Rotation centers: the point whose images under a joint-set's transforms lie closest together [Kavan and Zara 2005b].
//
// For two joints let (w, v) be the relative rotation q_a* q_b and e = R_a^T (C_a p - C_b p) how far apart they carry the
// prior p, seen from joint a. Then R_a^T (C_a (p + x) - C_b (p + x)) = e + (1 - R) x, and with
// (1 - R)^T (1 - R) = 4 (||v||^2 - v v^T) and (1 - R)^T e = 2 (w v x e - v x (v x e)) the normal equations M x = g of n joints
// are sums over their pairs, free of trigonometry and of cancellation at small angles. For two joints the solution nearest
// to 0 is x = (v x (v x e) - w v x e) / (2 ||v||^2).
//
// V = sum of the v v^T has a trace t, and M = 4 (t - V): all eigenvalues of M are at most 4 t, and only one of them can be
// below 2 t, since two of V's are never both above t/2. So the rank of M is 0, 2 or 3, the one direction in question is
// V's largest eigenvector, and no eigensolver is needed: where that eigenvalue of M is small, the direction is that of
// the eighth power of M's adjugate, which this very smallness makes a product n n^T.
#pragma once

#include <span>

#include "algorithms/model/model.hpp"

namespace refitlab {

// argmin_r of the sum over all pairs a < b of ||C_a r - C_b r||^2. Where the minimum is not unique (a single joint, equal
// transforms, parallel axes: any point of a line or plane will do), the minimiser nearest to prior. Directions in which
// the rotations differ by less than 1e-3 of their largest difference, or by less than 1e-4 rad, count as undetermined:
// they could only move the center far away for nothing. (Differences are square roots of sums over pairs; the largest is
// taken to be that of the sum over all directions, 2 sqrt(t), which it reaches for parallel axes.) All points in the
// reference frame; rotations of unit length, whatever their signs.
Point3 rotation_center(std::span<const RigidTransform<double>> transforms, const Point3& prior);

}  // namespace refitlab
