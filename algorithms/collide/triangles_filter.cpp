#include "algorithms/collide/triangles_filter.hpp"

#include <algorithm>
#include <cmath>

namespace refitlab {
namespace {

using Point = Vec<double, 3>;

// The sign of (b - a, c - a, d - a), the determinant of the differences; 0 if it is not certain.
//
// With u = 2^-53 and X, Y, Z the largest computed |differences| by coordinate: each of the six products of three
// differences is at most XYZ (1 + u)^3 in exact differences and carries at most 3 + 2 + 3 roundings (differences, products, sums), each a
// factor within 1 +- u. So the computed determinant is off by at most 6 XYZ ((1 + u)^11 - 1) < 67 u XYZ < 7.5e-15 XYZ; the
// bound below leaves a third for its own roundings. Where XYZ is so small that products may have underflowed, nothing is certain.
int sign_of_determinant(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double determinant = (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
  const double largest_x = std::max({std::abs(bx), std::abs(cx), std::abs(dx)});
  const double largest_y = std::max({std::abs(by), std::abs(cy), std::abs(dy)});
  const double largest_z = std::max({std::abs(bz), std::abs(cz), std::abs(dz)});
  const double error = 1e-14 * largest_x * largest_y * largest_z;
  if (!(error > 1e-280)) return 0;
  return determinant > error ? 1 : determinant < -error ? -1 : 0;
}

// The sides of a plane that three points are on.
struct Sides {
  int of[3];
  bool is_certain() const { return of[0] != 0 && of[1] != 0 && of[2] != 0; }
  bool is_one() const { return is_certain() && of[0] == of[1] && of[1] == of[2]; }
  // Of sides that are not one: the corner that is alone on its side.
  int alone() const { return of[0] == of[1] ? 2 : of[0] == of[2] ? 1 : 0; }
};

Sides sides(const TrianglePoints& plane, const TrianglePoints& points) {
  const auto side = [&](int i) { return sign_of_determinant(plane[0], plane[1], plane[2], points[i]); };
  return {{side(0), side(1), side(2)}};
}

}  // namespace

Filtered filter_triangles(const TrianglePoints& a, const TrianglePoints& b) {
  const Sides of_b = sides(a, b);
  if (of_b.is_one()) return Filtered::apart;
  const Sides of_a = sides(b, a);
  if (of_a.is_one()) return Filtered::apart;
  if (!of_a.is_certain() || !of_b.is_certain()) return Filtered::unknown;

  // Turned so that each first corner is alone, and above the other's plane.
  const int p0 = of_a.alone(), q0 = of_b.alone();
  int p1 = (p0 + 1) % 3, p2 = (p0 + 2) % 3, q1 = (q0 + 1) % 3, q2 = (q0 + 2) % 3;
  if (of_a.of[p0] < 0) std::swap(q1, q2);
  if (of_b.of[q0] < 0) std::swap(p1, p2);
  // Each triangle's crossings of the shared line are an interval; neither begins where the other has ended.
  const int first = sign_of_determinant(a[p0], a[p1], b[q0], b[q1]);
  if (first > 0) return Filtered::apart;
  const int second = sign_of_determinant(a[p0], a[p2], b[q2], b[q0]);
  if (second > 0) return Filtered::apart;
  return first < 0 && second < 0 ? Filtered::meet : Filtered::unknown;
}

}  // namespace refitlab
