// SPDX-License-Identifier: MIT
// This query finds the touching triangles of two skinned characters by their sphere trees, refitted on demand (paper 5).
#pragma once

#include "algorithms/runtime/collide/body.hpp"

namespace refitlab {

// A PlacedBody is a body and its placement. The placement takes the body's model space to the world, in the same units for all
// bodies.
struct PlacedBody {
  Body& body;
  RigidTransform<double> placement = {};
};

enum class Query {
  full,   // all pairs
  yes_no  // stop at the first pair found
};

struct TrianglePair {
  int first, second;  // indices into the triangles of the first and of the second body
  auto operator<=>(const TrianglePair&) const = default;
};

struct QueryCounts {
  long ball_tests = 0, triangle_tests = 0;
};

// Returns the pairs of triangles, one of each body, that have a point in common, in no particular order. Each pair is
// decided exactly for the vertices in the world as apply(placement, skinned vertex) computes them in double. So for every
// sound variant, the result is the same as from testing all pairs. The bodies may be one and the same, in one pose and two
// placements. They keep what was refitted and skinned for further queries in the frame, so a body is in one query at a
// time; characters are in as many as one likes. Throws std::invalid_argument for a placement that is not finite or whose rotation
// differs from unit length by more than 1e-6, and std::logic_error for a body that has begun no frame.
std::vector<TrianglePair> collide(const PlacedBody& first, const PlacedBody& second, Query query, QueryCounts& counts);

// Returns a triangle's vertices in the world.
TrianglePoints place(const RigidTransform<double>& placement, const TrianglePoints& triangle);

}  // namespace refitlab
