// SPDX-License-Identifier: GPL-3.0-or-later
// This measures growth with the number of triangles. The man's mesh is made coarser and finer, and two men pass at the same
// distances.
#pragma once

#include <string>
#include <vector>

#include "experiments/collisions/collisions.hpp"

namespace refitlab {

struct TriangleGrowthSettings {
  int frames = 4;
  int subdivisions = 2;  // at most: 1 goes to 33,080 triangles, 2 to 132,320, and 3 to a million
  SpeedSettings speed;
};

struct TriangleGrowth {
  int triangles;
  CollisionResult result;  // of a full query in the scene far, near, light or heavy
};

// Returns the growth by scene, number and detector. The detectors are clusters, three variants on demand, Embree, and
// skin_all_float, with which the others must agree.
std::vector<TriangleGrowth> run_triangle_growth(const TriangleGrowthSettings& settings);

void write_triangle_growth(const std::vector<TriangleGrowth>& rows, const std::string& path);

}  // namespace refitlab
