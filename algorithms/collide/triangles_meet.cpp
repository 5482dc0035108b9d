#include "algorithms/collide/triangles_meet.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <variant>

#include "algorithms/packs/float_environment.hpp"

namespace refitlab {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Shape = std::variant<Kernel::Triangle_3, Segment, Point>;

// What the three points span: CGAL's tests want no triangle of collinear corners and no segment of equal ends.
Shape shape_of(const TrianglePoints& t) {
  const auto point = [&](int i) { return Point(t[i][0], t[i][1], t[i][2]); };
  const Point a = point(0), b = point(1), c = point(2);
  if (!CGAL::collinear(a, b, c)) return Kernel::Triangle_3(a, b, c);
  const auto [low, high] = std::minmax({a, b, c}, [](const Point& p, const Point& q) { return CGAL::lexicographically_xyz_smaller(p, q); });
  if (low == high) return low;
  return Segment(low, high);
}

struct Meet {
  bool operator()(const Point& a, const Point& b) const { return a == b; }
  bool operator()(const Segment& a, const Point& b) const { return a.has_on(b); }
  bool operator()(const Point& a, const Segment& b) const { return b.has_on(a); }
  template <class A, class B>
  bool operator()(const A& a, const B& b) const {
    return CGAL::do_intersect(a, b);
  }
};

// By far the most pairs that are asked about are apart in one coordinate.
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
  return quick == Filtered::unknown ? std::visit(Meet{}, shape_of(a), shape_of(b)) : quick == Filtered::meet;
}

bool triangles_meet(const TrianglePoints& a, const TrianglePoints& b) {
  const DefaultFloatEnvironment environment;
  return boxes_meet(a, b) && boxed_triangles_meet(a, b);
}

}  // namespace refitlab
