// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/triangles_meet.hpp"

#include <algorithm>

#include "algorithms/runtime/collide/exact_number.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// There are nine differences of a vertex of one triangle and one of the other. The triangles have a point in common if 0 is in
// the hull of the differences, and so in the hull of at most four of them [Caratheodory 1911]. That is a tetrahedron, or, if all
// that hold 0 are flat, a triangle, a segment or a point.
class Differences {
 public:
  Differences(const TrianglePoints& a, const TrianglePoints& b) : a_(a), b_(b) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int c = 0; c < 3; ++c) exact_[3 * i + j][c] = ExactNumber(a[i][c]) - ExactNumber(b[j][c]);
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j)
        for (int k = j + 1; k < count; ++k) side_[i][j][k] = sign_of_determinant(i, j, k);
  }

  bool have_zero_in_hull() const {
    for (int i = 0; i < count; ++i)
      for (int j = i; j < count; ++j) {
        if (is_on_segment(i, j)) return true;
        for (int k = j + 1; k < count; ++k) {
          if (j == i) continue;
          if (is_in_triangle(i, j, k)) return true;
          for (int l = k + 1; l < count; ++l)
            if (is_in_tetrahedron(i, j, k, l)) return true;
        }
      }
    return false;
  }

 private:
  static constexpr int count = 9;
  using Vector = std::array<ExactNumber, 3>;

  static Vector cross_of(const Vector& x, const Vector& y) {
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  }
  static int sign_of_dot(const Vector& x, const Vector& y) { return (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]).sign(); }
  static bool is_zero(const Vector& x) { return x[0].sign() == 0 && x[1].sign() == 0 && x[2].sign() == 0; }

  // Few determinants are so near to 0 that double does not know their signs.
  int sign_of_determinant(int i, int j, int k) const {
    const auto in_double = [&](int n) { return Vec<double, 3>(a_[n / 3] - b_[n % 3]); };
    const Vec<double, 3> p = in_double(i), q = in_double(j), r = in_double(k);
    DifferenceExtent<double> extent;
    extent.add(p), extent.add(q), extent.add(r);
    const Sign<bool> quick = extent.sign_of(dot<double, 3>(cross<double>(p, q), r));
    if (quick.is_positive || quick.is_negative) return quick.is_positive ? 1 : -1;
    return sign_of_dot(cross_of(exact_[i], exact_[j]), exact_[k]);
  }

  bool is_on_segment(int i, int j) const {
    return sign_of_dot(exact_[i], exact_[j]) <= 0 && is_zero(cross_of(exact_[i], exact_[j]));
  }
  // The triangle is in one plane with 0, and its three triangles with 0 have normals that point the same way.
  bool is_in_triangle(int i, int j, int k) const {
    if (side_[i][j][k] != 0) return false;
    const Vector ij = cross_of(exact_[i], exact_[j]), jk = cross_of(exact_[j], exact_[k]), ki = cross_of(exact_[k], exact_[i]);
    if (is_zero(ij) && is_zero(jk) && is_zero(ki)) return false;  // on a line with 0: a segment's matter
    return sign_of_dot(ij, jk) >= 0 && sign_of_dot(jk, ki) >= 0 && sign_of_dot(ki, ij) >= 0;
  }
  // The barycentric coordinates of 0 are proportional to these determinants: no two have opposite signs, and not all are 0.
  bool is_in_tetrahedron(int i, int j, int k, int l) const {
    const int signs[4] = {side_[j][k][l], -side_[i][k][l], side_[i][j][l], -side_[i][j][k]};
    const auto [low, high] = std::minmax_element(signs, signs + 4);
    return *low >= 0 ? *high > 0 : *high <= 0;
  }

  const TrianglePoints &a_, &b_;
  std::array<Vector, count> exact_;
  int side_[count][count][count];  // by increasing indices: the sign of the determinant of three differences
};

// By far the most pairs are apart in one coordinate.
bool boxes_meet(const TrianglePoints& a, const TrianglePoints& b) {
  for (int i = 0; i < 3; ++i) {
    const auto [a_low, a_high] = std::minmax({a[0][i], a[1][i], a[2][i]});
    const auto [b_low, b_high] = std::minmax({b[0][i], b[1][i], b[2][i]});
    if (a_high < b_low || b_high < a_low) return false;
  }
  return true;
}

}  // namespace

bool boxed_triangles_meet(const TrianglePoints& a, const TrianglePoints& b) {
  const DefaultFloatEnvironment environment;
  const Filtered quick = filter_triangles(a, b);
  return quick == Filtered::unknown ? Differences(a, b).have_zero_in_hull() : quick == Filtered::meet;
}

bool triangles_meet(const TrianglePoints& a, const TrianglePoints& b) {
  const DefaultFloatEnvironment environment;
  return boxes_meet(a, b) && boxed_triangles_meet(a, b);
}

}  // namespace refitlab
