// SPDX-License-Identifier: MIT
// Quaternions are vectors of R^4 in the order (w, x, y, z). The real part is first, as in the paper's q = (1, 0, 0, 0).
//
// A non-zero quaternion q stands for the rotation x -> q x q* / ||q||^2 of R^3, angle in radians, right-handed. q and any
// k q with k != 0 are the same rotation, but q and -q blend differently.
#pragma once

#include <array>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

template <class S>
using Quaternion = Vec<S, 4>;

template <class S>
Quaternion<S> identity_quaternion() {
  return {S(1), S(0), S(0), S(0)};
}

template <class S>
Vec<S, 3> imaginary(const Quaternion<S>& q) {
  return {q[1], q[2], q[3]};
}

template <class S>
Quaternion<S> pure_quaternion(const Vec<S, 3>& x) {
  return {S(0), x[0], x[1], x[2]};
}

template <class S>
Quaternion<S> conjugate(const Quaternion<S>& q) {
  return {q[0], -q[1], -q[2], -q[3]};
}

template <class S>
Quaternion<S> multiply(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

// Returns Im(q x q*), which is ||q||^2 times the rotated x, without a division. q has any length.
template <class S>
Vec<S, 3> rotate_scaled(const Quaternion<S>& q, const Vec<S, 3>& x) {
  const Vec<S, 3> v = imaginary(q);
  const S along = (dot(v, x)) * S(2);
  const S keep = sq(q[0]) - squared_norm(v);
  const Vec<S, 3> turn = cross(v, x);
  const S twice_w = q[0] * S(2);
  return {keep * x[0] + along * v[0] + twice_w * turn[0], keep * x[1] + along * v[1] + twice_w * turn[1],
          keep * x[2] + along * v[2] + twice_w * turn[2]};
}

// Returns R_q x - x, by which the rotation of q displaces x. scale is 2 / ||q||^2, so q has any length but 0.
template <class S>
Vec<S, 3> rotation_displacement(const Quaternion<S>& q, const S& scale, const Vec<S, 3>& x) {
  const Vec<S, 3> v = imaginary(q);
  const Vec<S, 3> t = cross(v, x);
  const Vec<S, 3> tt = cross(v, t);
  return {scale * (q[0] * t[0] + tt[0]), scale * (q[0] * t[1] + tt[1]), scale * (q[0] * t[2] + tt[2])};
}

// Returns the rotated x for a unit q.
template <class S>
Vec<S, 3> rotate(const Quaternion<S>& unit, const Vec<S, 3>& x) {
  const Vec<S, 3> displacement = rotation_displacement(unit, S(2), x);
  return {x[0] + displacement[0], x[1] + displacement[1], x[2] + displacement[2]};
}

// Let ||q||^2 = n, which is not quite 1 for a computed unit quaternion. rotate(q, x) is n R_q x + (1 - n) x then. This returns
// how far that is from R_q x at most, as a share of ||x||, for defects |1 - n| up to this one.
template <class S>
constexpr S error_of_rotate(const S& defect) {
  return S(2) * defect;
}
// Returns by which factor rotate(q, x) stretches x at most.
template <class S>
S stretch_of_rotate(const S& squared_length) {
  return squared_length + absolute<S>(S(1) - squared_length);
}

// Returns the rows of the matrix of rotate(), which is the rotation's for a unit q (QUAT2MATRIX of Algorithm 1).
template <class S>
std::array<Vec<S, 3>, 3> rotation_rows(const Quaternion<S>& unit) {
  const S x = unit[1] + unit[1], y = unit[2] + unit[2], z = unit[3] + unit[3];
  const S wx = unit[0] * x, wy = unit[0] * y, wz = unit[0] * z;
  const S xx = unit[1] * x, xy = unit[1] * y, xz = unit[1] * z, yy = unit[2] * y, yz = unit[2] * z, zz = unit[3] * z;
  return {Vec<S, 3>(S(1) - (yy + zz), xy - wz, xz + wy), Vec<S, 3>(xy + wz, S(1) - (xx + zz), yz - wx),
          Vec<S, 3>(xz - wy, yz + wx, S(1) - (xx + yy))};
}

}  // namespace refitlab
