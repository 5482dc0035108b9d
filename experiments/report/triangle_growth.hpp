// The report's section on growth with the number of triangles.
#pragma once

#include <string>
#include <vector>

#include "experiments/growth/triangles.hpp"

namespace refitlab {

// Empty without rows.
std::string triangle_growth_section(const std::vector<TriangleGrowth>& rows);

}  // namespace refitlab
