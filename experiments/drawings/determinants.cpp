// SPDX-License-Identifier: GPL-3.0-or-later
// This is the drawing of the lemma about the sides of a triangle's plane.
#include "experiments/drawings/common.hpp"
#include "lemmas/b10_determinant_error.hpp"

namespace refitlab::drawings {
namespace {

constexpr double off = 0.03, from = -0.2, to = 2;

// A plane, seen from the side: of three points, the third is nearer to the eye. A fourth point is in the plane of the first two.
FourPoints<double> points_with(const Point &fourth) {
  return {Point3D(0, 0, 0), Point3D(1.8, 0, 0.45), Point3D(0.8, 1.2, 0.2), Point3D(fourth[0], 0, fourth[1])};
}
Point from_the_side(const Point3D &v) { return {v[0], v[2]}; }

// Returns how far above the plane, or below it by the factor -1, a point has to be for its side to be certain.
template <class Bound>
Point last_uncertain(double x, double factor, const Bound &bound) {
  const double height = x / 4;
  double low = 0, high = 4;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    const FourPoints<double> at = points_with({x, height + factor * middle});
    Point3D extent(0, 0, 0);
    for (int k = 1; k < 4; ++k)
      for (int j = 0; j < 3; ++j) extent[j] = std::max(extent[j], std::abs(at[k][j] - at[0][j]));
    const double allowed = bound(at, CoordinateErrors<double>{off, extent});
    (std::abs(determinant_of<double>(at)) <= allowed ? low : high) = middle;
  }
  return {x, height + factor * low};
}
template <class Bound>
void draw_uncertain(Plane &p, const std::string &kind, const Bound &bound) {
  std::vector<Point> around;
  constexpr int steps = 48;
  for (int i = 0; i <= steps; ++i) around.push_back(last_uncertain(from + (to - from) * i / steps, 1, bound));
  for (int i = steps; i >= 0; --i) around.push_back(last_uncertain(from + (to - from) * i / steps, -1, bound));
  p.path(kind, around, true);
}

void b10(Plane &p) {
  draw_uncertain(p, "outer", [](const auto &, const auto &errors) { return errors.by_extents(); });
  draw_uncertain(p, "hull", [](const auto &at, const auto &errors) { return errors.by_slopes(at); });
  p.path("plane", {{from, from / 4}, {to, to / 4}});
  const FourPoints<double> at = points_with({1.2, 0.7});
  const char *names[] = {"a", "b", "c", "d"};
  for (int k = 0; k < 4; ++k) {
    const Point center = from_the_side(at[k]), right(off, 0), up(0, off);
    p.path("printed", {center - right - up, center + right - up, center + right + up, center - right + up}, true);
    p.dot(k == 3 ? "dot_in" : "dot", center, names[k]);
  }
}

}  // namespace

const std::vector<Drawing> &drawings_of_determinants() {
  static const std::vector<Drawing> all{
      {"b10_determinant_error", b10,
       "From the side: the plane of a, b and c, and a point d, where each may be anywhere in its square. Beyond the filled band, "
       "which the slopes bound, d is on its side for certain; the extents bound the wider band (dashed)."}};
  return all;
}

}  // namespace refitlab::drawings
