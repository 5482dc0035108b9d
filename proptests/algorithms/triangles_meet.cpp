// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/triangles_meet.hpp"

#include <rapidcheck.h>

#include "proptests/harness/harness.hpp"
#include "proptests/oracles/triangles_meet.hpp"

namespace proptests::suite_triangles_meet {
namespace {

using namespace refitlab;

Vec<double, 3> normal(const TrianglePoints& t) { return cross<double>(t[1] - t[0], t[2] - t[0]); }
bool is_flat(const TrianglePoints& t) { return normal(t).isZero(0); }

Vec<double, 3> grid_point(int size) {
  const auto coordinate = [&] { return double(*rc::gen::inRange(-size, size + 1)); };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

TrianglePoints grid_triangle(int size) {
  const auto a = grid_point(size), b = grid_point(size);
  return {a, b, grid_point(size)};
}

bool symmetric(const TrianglePoints& a, const TrianglePoints& b) {
  const bool answer = triangles_meet(a, b);
  return triangles_meet(b, a) == answer && triangles_meet({a[1], a[2], a[0]}, {b[0], b[2], b[1]}) == answer;
}

}  // namespace

PROPTEST(triangles_meet) {
  t.holds("on a grid, where triangles touch, lie in one plane or collapse, the answer is that of exact arithmetic",
          {.number_type = "rational", .cases = 3000, .degenerate_at_least = 0.3}, [] {
            const int size = *rc::gen::element(1, 2, 4);
            const TrianglePoints a = grid_triangle(size), b = grid_triangle(size);
            const bool meets = oracle::triangles_meet(a, b);
            RC_CLASSIFY(is_flat(a) || is_flat(b) || cross(normal(a), normal(b)).isZero(0), "degenerate");
            RC_CLASSIFY(meets, "meet");
            RC_ASSERT(triangles_meet(a, b) == meets);
            RC_ASSERT(symmetric(a, b));
          });
  t.holds("a corner moved onto an edge or a face of the other, up to rounding, is decided by the digits that are there",
          {.number_type = "rational", .cases = 1000, .degenerate_at_least = 0.3, .degenerate_at_most = 1}, [] {
            const TrianglePoints a = grid_triangle(9);
            TrianglePoints b = grid_triangle(9);
            const double s = *rc::gen::inRange(0, 8) / 7.0, t = *rc::gen::inRange(0, 8) / 7.0;
            const int shift = *rc::gen::inRange(-2, 3);
            // It is on the face but for rounding.
            b[0] = a[0] * (1 - s) + (a[1] * (1 - t) + a[2] * t) * s;
            b[0][0] = shift < 0 ? std::nextafter(b[0][0], -100) : shift > 0 ? std::nextafter(b[0][0], 100) : b[0][0];
            const bool meets = oracle::triangles_meet(a, b);
            RC_CLASSIFY(filter_triangles(a, b) == Filtered::unknown, "degenerate");
            RC_CLASSIFY(meets, "meet");
            RC_ASSERT(triangles_meet(a, b) == meets);
          });
  t.holds("the units do not matter: coordinates from 1e-308 to 1e308, which overflow and underflow in products",
          {.number_type = "rational", .cases = 500, .degenerate_at_least = 0.2}, [] {
            const double unit = *rc::gen::element(0x1p-100, 0x1p100, 0x1p341, 0x1p342, 0x1p500, 0x1p1022, 0x1p-341, 0x1p-360,
                                                  0x1p-500, 0x1p-1022, 0x1p-1074);
            TrianglePoints a = grid_triangle(2), b = grid_triangle(2);
            RC_CLASSIFY(is_flat(a) || is_flat(b), "degenerate");
            const bool meets = oracle::triangles_meet(a, b);
            for (int i = 0; i < 3; ++i) a[i] *= unit, b[i] *= unit;
            RC_ASSERT(triangles_meet(a, b) == meets);
          });
}

}  // namespace proptests::suite_triangles_meet
