// Skinning by matrices, written from the paper's equations and from nothing in algorithms/: slow and obvious.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "lemmas/vocabulary/rigid.hpp"

namespace proptests::oracle {

// A 3x4 matrix (R | t), row by row.
template <class S>
using Affine = std::array<std::array<S, 4>, 3>;

// The rotation matrix of a quaternion (w, x, y, z) of any length but 0, from the textbook entries, and a translation.
template <class S>
Affine<S> affine_of(const refitlab::Quaternion<S>& q, const refitlab::Vec<S, 3>& t) {
  const S w = q[0], x = q[1], y = q[2], z = q[3], n = w * w + x * x + y * y + z * z, two(2);
  return {{{(w * w + x * x - y * y - z * z) / n, two * (x * y - w * z) / n, two * (x * z + w * y) / n, t[0]},
           {two * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, two * (y * z - w * x) / n, t[1]},
           {two * (x * z - w * y) / n, two * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n, t[2]}}};
}

template <class S>
refitlab::Vec<S, 3> times(const Affine<S>& m, const refitlab::Vec<S, 3>& x) {
  refitlab::Vec<S, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = m[i][0] * x[0] + m[i][1] * x[1] + m[i][2] * x[2] + m[i][3];
  return out;
}

// (sum w_i C_i) v: the matrices are blended, not the points.
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

// Equation (1) with the matrix Q_w of the blended quaternion.
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

// The same by Eigen's own quaternions and transforms, in double.
Eigen::Vector3d linear_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                const Eigen::Vector3d& v);
Eigen::Vector3d spherical_by_eigen(std::span<const refitlab::RigidTransform<double>> c, std::span<const double> w,
                                   const Eigen::Vector3d& center, const Eigen::Vector3d& v);

}  // namespace proptests::oracle
