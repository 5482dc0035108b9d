// SPDX-License-Identifier: MIT
// A Polytope is a bounded intersection of half-spaces, with its volume and surface area. Each face is the part of its plane that
// the other half-spaces leave.
#pragma once

#include <utility>
#include <vector>

#include "lemmas/vocabulary/cap.hpp"

namespace refitlab {

template <class S>
class Polytope {
 public:
  // Makes {x : (x, normal) >= offset for every half-space}. All of it is within this distance of the origin, and it is not empty.
  // The normals' squared lengths are between 1 and 3, and no two half-spaces have the same. S is ordered, as a floating-point or
  // an exact type is.
  Polytope(std::vector<HalfSpace<S, 3>> half_spaces, const S& reach) : half_spaces_(std::move(half_spaces)), reach_(reach) {}

  // Returns the sum of the pyramids from the origin over all faces, which is 0 for a flat polytope. It is most accurate near the
  // origin, as distance costs digits.
  S volume() const {
    S sum(0);
    for (const auto& h : half_spaces_) sum = sum - h.offset * dot(doubled_area(h), h.normal) / (S(6) * squared_norm(h.normal));
    return sum;
  }

  // Returns the surface area. For a flat polytope it is twice the area, which counts both sides.
  S surface_area() const {
    S sum(0);
    for (const auto& h : half_spaces_) sum = sum + norm(doubled_area(h)) / S(2);
    return sum;
  }

 private:
  using Point = Vec<S, 3>;

  // Returns twice the area of the face as a vector along its normal.
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

  // Returns a square of the face's plane that holds all of the plane within the reach, counterclockwise about the normal. Its
  // half-diagonals u and v are at least 2 reach * sqrt(2/3) long, so that a circle of 1.15 reach fits in.
  std::vector<Point> square(const HalfSpace<S, 3>& face) const {
    const Point& n = face.normal;
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (prefer_less(sq(n[i]), sq(n[least]))) least = i;
    Point axis(S(0), S(0), S(0));
    axis[least] = S(1);
    const Point foot = n * S(face.offset / squared_norm(n));
    const Point u = cross<S>(n, axis) * S(S(2) * reach_), v = cross<S>(n, u);
    return {foot + u, foot + v, foot - u, foot - v};
  }

  // Computes the part of a convex polygon that h leaves [Sutherland and Hodgman 1974].
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
  S reach_;
};

}  // namespace refitlab
