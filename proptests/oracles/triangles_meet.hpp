// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether two triangles have a point in common, in exact arithmetic.
#pragma once

#include "algorithms/runtime/collide/triangles_filter.hpp"

namespace proptests::oracle {

// Says whether two triangles meet, which they do if and only if 0 is a convex combination of the nine differences of their
// vertices.
bool triangles_meet(const refitlab::TrianglePoints& a, const refitlab::TrianglePoints& b);

}  // namespace proptests::oracle
