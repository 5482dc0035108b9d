// SPDX-License-Identifier: MIT
// Decides exactly whether two triangles have a point in common.
#pragma once

#include "algorithms/runtime/collide/triangles_filter.hpp"

namespace refitlab {

// Both triangles are closed, that is, they include their edges and vertices. The doubles are taken as exact, and all must be
// finite. The answer is right for them, also for triangles that touch, lie in one plane, or are no more than a segment or a
// point. The function uses filter_triangles. Where that has no answer, it uses the hull of the differences of their
// vertices, in exact numbers.
bool triangles_meet(const TrianglePoints& a, const TrianglePoints& b);

// Decides the same for triangles whose boxes are known to meet. Most pairs that do not touch are told apart by their boxes
// already.
bool boxed_triangles_meet(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace refitlab
