#include "algorithms/skinning/rotation_center.hpp"

#include <Eigen/Eigenvalues>

namespace refitlab {
namespace {

Eigen::Matrix3d rotation_matrix(const Quaternion<double>& q) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) m.col(i) = rotate<double>(q, Point3::Unit(i));
  return m;
}

}  // namespace

Point3 rotation_center(std::span<const RigidTransform<double>> transforms, const Point3& prior) {
  std::vector<Eigen::Matrix3d> rotations;
  for (const auto& t : transforms) rotations.push_back(rotation_matrix(t.rotation));
  // Normal equations for the offset from prior: M x = g, M symmetric and positive semidefinite.
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (std::size_t a = 0; a < transforms.size(); ++a)
    for (std::size_t b = a + 1; b < transforms.size(); ++b) {
      const Eigen::Matrix3d difference = rotations[a] - rotations[b];
      const Point3 apart = apply(transforms[a], prior) - apply(transforms[b], prior);
      m += difference.transpose() * difference;
      g -= difference.transpose() * apart;
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(m);
  const double determined = std::max(1e-8, 1e-6 * eigen.eigenvalues()[2]);  // squares of the tolerances
  Point3 offset = Point3::Zero();
  for (int i = 0; i < 3; ++i)
    if (eigen.eigenvalues()[i] > determined)
      offset += eigen.eigenvectors().col(i) * (eigen.eigenvectors().col(i).dot(g) / eigen.eigenvalues()[i]);
  return prior + offset;
}

}  // namespace refitlab
