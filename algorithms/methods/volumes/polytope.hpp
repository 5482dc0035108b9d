// SPDX-License-Identifier: MIT
// Volume and surface area of a polytope given as a bounded intersection of half-spaces: each face is what the others
// leave of its plane.
#pragma once

#include <utility>
#include <vector>

#include "lemmas/vocabulary/cap.hpp"

namespace refitlab {

template <class S>
class Polytope {
 public:
  // {x : (x, normal) >= offset for every half-space}, all of it within this distance of the origin, and not empty. The
  // normals' squared lengths are between 1 and 3, and no two half-spaces have the same. S is ordered: a floating or an
  // exact type.
  Polytope(std::vector<HalfSpace<S, 3>> half_spaces, const S& reach)
      : half_spaces_(std::move(half_spaces)),
        motion_bound_(reach) {}

  // The pyramids from the origin over all faces; 0 for a flat one. Best near the origin: its place costs digits.
  S volume() const {
    S sum(0);
    for (const auto& h : half_spaces_) sum = sum - h.offset * dot(doubled_area(h), h.normal) / (S(6) * squared_norm(h.normal));
    return sum;
  }

  // Twice the area for a flat one: both of its sides.
  S surface_area() const {
    S sum(0);
    for (const auto& h : half_spaces_) sum = sum + norm(doubled_area(h)) / S(2);
    return sum;
  }

 private:
  using Point = Vec<S, 3>;

  // Twice the area of the face of h as a vector along h.normal.
  Point doubled_area(const HalfSpace<S, 3>& face) const {
    std::vector<Point> polygon = square(face), kept;
    for (const auto& h : half_spaces_) {
      if (h.normal == face.normal || h.normal == -face.normal) continue;  // parallel: cuts nothing off
      clip(polygon, h, kept);
      polygon.swap(kept);
      if (polygon.size() < 3) return Point(S(0), S(0), S(0));
    }
    Point sum(S(0), S(0), S(0));
    for (std::size_t i = 2; i < polygon.size(); ++i) sum += cross<S>(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return sum;
  }

  // A square of the face's plane that holds all of the plane within the reach, counterclockwise about the normal. Its
  // half-diagonals u and v are at least 2 reach * sqrt(2/3) long, so that a circle of 1.15 reach fits in.
  std::vector<Point> square(const HalfSpace<S, 3>& face) const {
    const Point& n = face.normal;
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (prefer_less(sq(n[i]), sq(n[least]))) least = i;
    Point axis(S(0), S(0), S(0));
    axis[least] = S(1);
    const Point foot = n * S(face.offset / squared_norm(n));
    const Point u = cross<S>(n, axis) * S(S(2) * motion_bound_), v = cross<S>(n, u);
    return {foot + u, foot + v, foot - u, foot - v};
  }

  // What h leaves of a convex polygon [Sutherland and Hodgman 1974].
  static void clip(const std::vector<Point>& polygon, const HalfSpace<S, 3>& h, std::vector<Point>& kept) {
    kept.clear();
    const S zero(0);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      const S inside_a = dot(a, h.normal) - h.offset, inside_b = dot(b, h.normal) - h.offset;
      if (!prefer_less(inside_a, zero)) kept.push_back(a);
      if (prefer_less(inside_a, zero) != prefer_less(inside_b, zero))
        kept.push_back(a + (b - a) * S(inside_a / (inside_a - inside_b)));
    }
  }

  std::vector<HalfSpace<S, 3>> half_spaces_;
  S motion_bound_;
};

}  // namespace refitlab
