// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/rotation_center.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "proptests/oracles/skinning.hpp"

namespace proptests::oracle {

RotationCenter rotation_center(std::span<const refitlab::RigidTransform<double>> transforms, const Eigen::Vector3d& prior) {
  const auto n = static_cast<Eigen::Index>(transforms.size());
  RotationCenter out{prior, 0, std::numeric_limits<double>::infinity(), Eigen::Matrix3d::Identity()};
  if (n < 2) return out;
  Eigen::MatrixXd stacked(3 * n * (n - 1) / 2, 3);
  Eigen::VectorXd apart(stacked.rows());
  Eigen::Index row = 0;
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index b = a + 1; b < n; ++b, row += 3) {
      const auto ca = affine_of(transforms[a].rotation, transforms[a].translation);
      const auto cb = affine_of(transforms[b].rotation, transforms[b].translation);
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) stacked(row + i, k) = ca[i][k] - cb[i][k];
      apart.segment<3>(row) = times<double>(ca, prior) - times<double>(cb, prior);
    }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(stacked, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double tolerance = std::max(1e-4, 1e-3 * svd.singularValues()[0]);
  for (int i = 0; i < 3; ++i) {
    const double s = svd.singularValues()[i];
    if (s > 0) out.nearest_to_tolerance = std::min(out.nearest_to_tolerance, std::abs(std::log10(s / tolerance)));
    if (s <= tolerance) continue;
    const Eigen::Vector3d v = svd.matrixV().col(i);
    out.point -= v * (svd.matrixU().col(i).dot(apart) / s);
    out.undetermined -= v * v.transpose();
    ++out.rank;
  }
  return out;
}

double sum_over_pairs(std::span<const refitlab::RigidTransform<double>> transforms, const Eigen::Vector3d& r) {
  double sum = 0;
  for (std::size_t a = 0; a < transforms.size(); ++a)
    for (std::size_t b = a + 1; b < transforms.size(); ++b)
      sum += (times<double>(affine_of(transforms[a].rotation, transforms[a].translation), r) -
              times<double>(affine_of(transforms[b].rotation, transforms[b].translation), r))
                 .squaredNorm();
  return sum;
}

}  // namespace proptests::oracle
