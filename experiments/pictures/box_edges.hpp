// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes are drawn by their edges.
#pragma once

#include "algorithms/runtime/balls/box.hpp"
#include "experiments/render/draw.hpp"

namespace refitlab {

// This is half the thickness of an edge, as a share of the picture.
inline constexpr double line_share = 0.0025;

inline std::vector<Point3> corners_of(const Box<float>& box) {
  std::vector<Point3> corners;
  for (int c = 0; c < 8; ++c)
    corners.emplace_back(c & 1 ? box.high[0] : box.low[0], c & 2 ? box.high[1] : box.low[1], c & 4 ? box.high[2] : box.low[2]);
  return corners;
}

inline void add_edges(render::Scene& scene, const Box<float>& box, double radius, render::Color color) {
  const std::vector<Point3> corners = corners_of(box);
  for (int c = 0; c < 8; ++c)
    for (const int bit : {1, 2, 4})
      if (!(c & bit)) scene.lines.push_back({{corners[c], corners[c | bit]}, radius, color});
}

}  // namespace refitlab
