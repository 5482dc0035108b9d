// SPDX-License-Identifier: GPL-3.0-or-later
// A PosedBody has the vertices of a character in one frame, which certificates of touching triangles are about.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algorithms/runtime/collide/cluster_body.hpp"

namespace refitlab {

struct PosedBody {
  std::string name;  // for the reader
  std::vector<Point3> vertices;
  std::vector<std::array<int, 3>> triangles;

  TrianglePoints triangle(int t) const {
    return {vertices[triangles[t][0]], vertices[triangles[t][1]], vertices[triangles[t][2]]};
  }
};

// Returns the doubles from which queries decide pairs. A vertex of no triangle stays where the mesh has it. The body must have
// begun a frame.
PosedBody posed_body(ClusterBody& body, const std::string& name);

}  // namespace refitlab
