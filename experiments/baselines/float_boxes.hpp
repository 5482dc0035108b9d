// SPDX-License-Identifier: GPL-3.0-or-later
// These are boxes of triangles in float, for engines that have no double and for SIMD lanes.
#pragma once

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/balls/box.hpp"

namespace refitlab {

// RoundedVertices are rounded to the nearest float. Rounding is monotone: if the boxes of two triangles overlap in double, so do
// those of their rounded vertices. So nothing has to be rounded outwards.
class RoundedVertices {
 public:
  void set(const std::vector<Point3>& vertices) {
    vertices_.resize(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) vertices_[v] = rounded(vertices[v]);
  }
  RowBox<float> box(const Triangle& t) const {
    RowBox<float> out{vertices_[t[0]], vertices_[t[0]]};
    out.merge(vertices_[t[1]]), out.merge(vertices_[t[2]]);
    return out;
  }

 private:
  static Row<float, 4> rounded(const Point3& p) { return Row<float, 4>{float(p[0]), float(p[1]), float(p[2]), 0}; }

  std::vector<Row<float, 4>> vertices_;  // the fourth numbers are 0
};

}  // namespace refitlab
