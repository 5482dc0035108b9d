// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/skinning.hpp"

namespace proptests::oracle {
namespace {

Eigen::Quaterniond eigen_quaternion(const refitlab::Quaternion<double>& q) { return {q[0], q[1], q[2], q[3]}; }

Eigen::Isometry3d isometry(const refitlab::RigidTransform<double>& c) {
  return Eigen::Translation3d(c.translation) * eigen_quaternion(c.rotation).normalized();
}

}  // namespace

Eigen::Vector3d linear_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                const Eigen::Vector3d& v) {
  Eigen::Matrix4d blend = Eigen::Matrix4d::Zero();
  for (std::size_t i = 0; i < c.size(); ++i) blend += w[i] * isometry(c[i]).matrix();
  return (blend * v.homogeneous()).hnormalized();
}

Eigen::Vector3d spherical_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                   const Eigen::Vector3d& center, const Eigen::Vector3d& v) {
  Eigen::Quaterniond q(0, 0, 0, 0);
  for (std::size_t i = 0; i < c.size(); ++i) q.coeffs() += w[i] * eigen_quaternion(c[i].rotation).coeffs();
  return q.normalized().toRotationMatrix() * (v - center) + linear_by_eigen(c, w, center);
}

Eigen::Vector3d dual_quaternion_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                         const Eigen::Vector3d& v) {
  Eigen::Quaterniond real(0, 0, 0, 0), dual(0, 0, 0, 0);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Eigen::Quaterniond q = eigen_quaternion(c[i].rotation);
    const auto& t = c[i].translation;
    real.coeffs() += w[i] * q.coeffs();
    dual.coeffs() += w[i] * (Eigen::Quaterniond(0, t[0] / 2, t[1] / 2, t[2] / 2) * q).coeffs();
  }
  const double n0 = real.norm(), n1 = real.dot(dual) / n0;
  Eigen::Quaterniond q, d;
  q.coeffs() = real.coeffs() / n0;
  d.coeffs() = dual.coeffs() / n0 - real.coeffs() * (n1 / (n0 * n0));
  const Eigen::Quaterniond turned = q * Eigen::Quaterniond(0, v[0], v[1], v[2]) * q.conjugate();
  return turned.vec() + (d * q.conjugate()).vec() - (q * d.conjugate()).vec();
}

}  // namespace proptests::oracle
