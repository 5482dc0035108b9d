// SPDX-License-Identifier: GPL-3.0-or-later
// common_point decides whether two triangles have a point in common. It gives the reason as numbers that anyone can check.
#pragma once

#include <array>
#include <variant>

#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "lemmas/exact/exact.hpp"

namespace refitlab {

// A CommonPoint has weights of the vertices of each triangle. They are not negative, have the sum 1, and make the same point of
// both.
struct CommonPoint {
  std::array<Rational, 3> first, second;
};
// A PartingPlane has all of the first triangle where the dot product with the normal is less than the offset, and all of the
// second where it is greater.
struct PartingPlane {
  Vec<Rational, 3> normal;
  Rational offset;
};

// The vertices must be finite; they are taken exactly. Both triangles are closed, and may be no more than a segment or a point.
// The function solves a linear program. The weights are a solution, and if there is none, the dual has the plane.
std::variant<CommonPoint, PartingPlane> common_point(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace refitlab
