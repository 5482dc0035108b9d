// A quick answer in double to whether two triangles have a point in common, or none where rounding might decide.
#pragma once

#include <array>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

using TrianglePoints = std::array<Vec<double, 3>, 3>;

enum class Filtered { apart, meet, unknown };

// apart and meet are right for the doubles as they are; unknown where the sign of a determinant is not certain: triangles
// that touch or nearly do, lie in one plane, or are flat. By the planes' sides and, where each triangle crosses the other's
// plane, the order of the crossings on the line that the planes share [Guigue and Devillers 2003].
Filtered filter_triangles(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace refitlab
