// SPDX-License-Identifier: GPL-3.0-or-later
// Growth with the number of triangles: the man's mesh coarser and finer, two of them passing at the same distances.
#pragma once

#include <string>
#include <vector>

#include "experiments/collisions/collisions.hpp"

namespace refitlab {

struct TriangleGrowthSettings {
  int frames = 4;
  bool up_to_a_million = false;  // else to 132,320
  SpeedSettings speed;
};

struct TriangleGrowth {
  int triangles;
  CollisionResult result;  // of a full query in the scene far, near, light or heavy
};

// By scene, number and detector: clusters, on demand by three variants, skin_all_float, which the others must agree with,
// and Embree.
std::vector<TriangleGrowth> run_triangle_growth(const TriangleGrowthSettings& settings);

void write_triangle_growth(const std::vector<TriangleGrowth>& rows, const std::string& path);

}  // namespace refitlab
