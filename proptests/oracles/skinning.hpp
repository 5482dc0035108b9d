// SPDX-License-Identifier: GPL-3.0-or-later
// Skins by matrices, written from the paper's equations and from nothing in algorithms/: slow and obvious.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <stdexcept>
#include <vector>

#include "lemmas/vocabulary/rigid.hpp"

namespace proptests::oracle {

// An Affine is a 3x4 matrix (R | t), row by row.
template <class S>
using Affine = std::array<std::array<S, 4>, 3>;

// Returns the rotation matrix of a quaternion (w, x, y, z) of any length but 0, from the textbook entries, and a translation.
template <class S>
Affine<S> affine_of(const refitlab::Quaternion<S>& q, const refitlab::Vec<S, 3>& t) {
  const S w = q[0], x = q[1], y = q[2], z = q[3], n = w * w + x * x + y * y + z * z, two(2);
  return {{{(w * w + x * x - y * y - z * z) / n, two * (x * y - w * z) / n, two * (x * z + w * y) / n, t[0]},
           {two * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, two * (y * z - w * x) / n, t[1]},
           {two * (x * z - w * y) / n, two * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n, t[2]}}};
}

// Returns the image of a point, by the first three rows of a matrix.
template <class S, std::size_t rows>
refitlab::Vec<S, 3> times(const std::array<std::array<S, 4>, rows>& m, const refitlab::Vec<S, 3>& x) {
  refitlab::Vec<S, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = m[i][0] * x[0] + m[i][1] * x[1] + m[i][2] * x[2] + m[i][3];
  return out;
}

// Returns (sum w_i C_i) v: the matrices are blended, not the points.
template <class S>
refitlab::Vec<S, 3> linear(const std::vector<refitlab::RigidTransform<S>>& c, const std::vector<S>& w,
                           const refitlab::Vec<S, 3>& v) {
  Affine<S> blend;
  for (auto& row : blend) row.fill(S(0));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Affine<S> m = affine_of(c[i].rotation, c[i].translation);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) blend[row][column] = blend[row][column] + w[i] * m[row][column];
  }
  return times(blend, v);
}

// Returns the vertex by equation (1) with the matrix Q_w of the blended quaternion.
template <class S>
refitlab::Vec<S, 3> spherical(const std::vector<refitlab::RigidTransform<S>>& c, const std::vector<S>& w,
                              const refitlab::Vec<S, 3>& center, const refitlab::Vec<S, 3>& v) {
  refitlab::Quaternion<S> q(S(0), S(0), S(0), S(0));
  for (std::size_t i = 0; i < c.size(); ++i)
    for (int k = 0; k < 4; ++k) q[k] = q[k] + w[i] * c[i].rotation[k];
  const refitlab::Vec<S, 3> arm = v - center;
  const refitlab::Vec<S, 3> nothing(S(0), S(0), S(0));
  const refitlab::Vec<S, 3> turned = times(affine_of(q, nothing), arm);
  return turned + linear(c, w, center);
}

// Returns a b, entry by entry of the multiplication table.
template <class S>
refitlab::Quaternion<S> hamilton(const refitlab::Quaternion<S>& a, const refitlab::Quaternion<S>& b) {
  static constexpr int unit[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  static constexpr int sign[4][4] = {{1, 1, 1, 1}, {1, -1, 1, -1}, {1, -1, -1, 1}, {1, 1, -1, -1}};
  refitlab::Quaternion<S> out(S(0), S(0), S(0), S(0));
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) out[unit[i][k]] = out[unit[i][k]] + S(sign[i][k]) * a[i] * b[k];
  return out;
}

// Blends the dual quaternions q + eps t q / 2 of the transforms. The part along q is taken away from the dual part, so that the
// blend is a unit dual quaternion but for its length. Then it applies the blend's matrix: the rotation of q, and the translation
// 2 d q* / ||q||^2, whose real part must be 0.
template <class S>
refitlab::Vec<S, 3> dual_quaternion(const std::vector<refitlab::RigidTransform<S>>& c, const std::vector<S>& w,
                                    const refitlab::Vec<S, 3>& v) {
  refitlab::Quaternion<S> q(S(0), S(0), S(0), S(0)), d = q;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto& t = c[i].translation;
    const auto tq = hamilton<S>({S(0), t[0], t[1], t[2]}, c[i].rotation);
    for (int k = 0; k < 4; ++k) {
      q[k] = q[k] + w[i] * c[i].rotation[k];
      d[k] = d[k] + w[i] * tq[k] / S(2);
    }
  }
  S length(0), along(0);
  for (int k = 0; k < 4; ++k) length = length + q[k] * q[k], along = along + q[k] * d[k];
  for (int k = 0; k < 4; ++k) d[k] = d[k] - q[k] * along / length;
  const auto t = hamilton<S>(d, {q[0], -q[1], -q[2], -q[3]});
  if (!(t[0] == S(0))) throw std::logic_error("the normalised blend is not a unit dual quaternion");
  const S two(2);
  return times(affine_of<S>(q, {two * t[1] / length, two * t[2] / length, two * t[3] / length}), v);
}

// These do the same by Eigen's own quaternions and transforms, in double.
Eigen::Vector3d linear_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                const Eigen::Vector3d& v);
Eigen::Vector3d spherical_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                   const Eigen::Vector3d& center, const Eigen::Vector3d& v);
// Works with dual numbers: the blend is divided by its norm n_0 + eps n_1, and then the sandwich is b (1 + eps v) b'*.
Eigen::Vector3d dual_quaternion_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                         const Eigen::Vector3d& v);

}  // namespace proptests::oracle
