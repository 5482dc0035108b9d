#include "algorithms/collide/triangles_filter.hpp"

#include <algorithm>
#include <cmath>

namespace refitlab {
namespace {

using Point = Vec<double, 3>;

// The largest |differences| seen, by coordinate.
struct Extent {
  double of[3] = {0, 0, 0};
  void add(const Point& difference) {
    for (int i = 0; i < 3; ++i) of[i] = std::max(of[i], std::abs(difference[i]));
  }
};

// Of a determinant of three differences; 0 if the sign is not certain.
//
// With u = 2^-53 and X, Y, Z the extent of the computed differences: each of the six products of three exact differences is at
// most XYZ (1 + u)^3 and carries at most 3 + 2 + 3 roundings (of differences, products and sums), each a factor within 1 +- u. So
// the computed determinant is off by at most 6 XYZ ((1 + u)^11 - 1) < 67 u XYZ < 7.5e-15 XYZ; the bound below leaves a
// third for its own roundings. Where XYZ is so small that products may have underflowed, nothing is certain.
int sign_of(double determinant, const Extent& differences) {
  const double error = 1e-14 * differences.of[0] * differences.of[1] * differences.of[2];
  if (!(error > 1e-280)) return 0;
  return determinant > error ? 1 : determinant < -error ? -1 : 0;
}

// The sign of (b - a, c - a, d - a).
int sign_of_determinant(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point p = b - a, q = c - a, r = d - a;
  Extent extent;
  extent.add(p), extent.add(q), extent.add(r);
  return sign_of(dot<double, 3>(cross<double>(p, q), r), extent);
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
  const Point p = plane[1] - plane[0], q = plane[2] - plane[0];
  const Point r[] = {points[0] - plane[0], points[1] - plane[0], points[2] - plane[0]};
  Extent extent;  // of all, for all three
  extent.add(p), extent.add(q);
  for (const Point& x : r) extent.add(x);
  const Point normal = cross<double>(p, q);
  const auto side = [&](int i) { return sign_of(dot<double, 3>(normal, r[i]), extent); };
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
