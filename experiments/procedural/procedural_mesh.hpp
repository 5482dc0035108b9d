// SPDX-License-Identifier: GPL-3.0-or-later
// These functions make triangle meshes of implicit bodies.
#pragma once

#include "experiments/procedural/procedural_body.hpp"

namespace refitlab {

struct SkinMesh {
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;  // counter-clockwise seen from outside
};

// Returns a mesh by marching tetrahedra on a grid of cubes with edges of length `cell`. It is a closed manifold of many uneven
// triangles.
SkinMesh polygonise(const ImplicitBody& body, double cell);

// Returns a mesh of the body's surface with exactly `triangle_count` triangles (even, fewer than polygonise() makes). They are as
// near to equilateral as may be, with edges in proportion to `size` at their place. Throws ModelError if the count is not
// reached.
SkinMesh mesh_of(const ImplicitBody& body, double cell, int triangle_count, const std::function<double(const Point3&)>& size);

}  // namespace refitlab
