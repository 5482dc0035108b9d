// SPDX-License-Identifier: MIT
// Whether two triangles have a point in common, decided exactly.
#pragma once

#include "algorithms/runtime/collide/triangles_filter.hpp"

namespace refitlab {

// Both triangles are closed: with their edges and corners. The doubles are taken as they are and the answer is right for
// them, also for triangles that touch, lie in one plane, or are no more than a segment or a point. All are finite.
// By filter_triangles, and where that does not know by the hull of the differences of their corners, in exact numbers.
bool triangles_meet(const TrianglePoints& a, const TrianglePoints& b);

// The same for triangles whose boxes are known to meet: most pairs that are not are told apart by these already.
bool boxed_triangles_meet(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace refitlab
