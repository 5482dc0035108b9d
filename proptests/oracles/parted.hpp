// SPDX-License-Identifier: GPL-3.0-or-later
// Checks what a plane between triangles and a common point of them have to be, in exact arithmetic.
#pragma once

#include "algorithms/certificate/common_point.hpp"

namespace proptests::oracle {

inline refitlab::Rational exact_product(const refitlab::Vec<refitlab::Rational, 3>& normal, const refitlab::Point3& p) {
  refitlab::Rational out(0);
  for (int i = 0; i < 3; ++i) out += normal[i] * refitlab::Rational(p[i]);
  return out;
}

// Says whether all vertices are strictly on the two sides.
inline bool parts(const refitlab::PartingPlane& plane, const refitlab::TrianglePoints& a, const refitlab::TrianglePoints& b) {
  for (int i = 0; i < 3; ++i)
    if (exact_product(plane.normal, a[i]) >= plane.offset || exact_product(plane.normal, b[i]) <= plane.offset) return false;
  return true;
}

inline bool is_common_point(const refitlab::CommonPoint& point, const refitlab::TrianglePoints& a,
                            const refitlab::TrianglePoints& b) {
  refitlab::Rational first(0), second(0);
  for (int i = 0; i < 3; ++i) {
    if (point.first[i] < 0 || point.second[i] < 0) return false;
    first += point.first[i], second += point.second[i];
  }
  for (int c = 0; c < 3; ++c) {
    refitlab::Rational apart(0);
    for (int i = 0; i < 3; ++i)
      apart += point.first[i] * refitlab::Rational(a[i][c]) - point.second[i] * refitlab::Rational(b[i][c]);
    if (apart != 0) return false;
  }
  return first == 1 && second == 1;
}

}  // namespace proptests::oracle
