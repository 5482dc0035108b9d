// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes of triangles in float, for engines that have no double and for SIMD lanes.
#pragma once

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/balls/box.hpp"

namespace refitlab {

// Vertices rounded to the nearest float. Rounding is monotone: where the boxes of two triangles overlap in double, so
// do those of their rounded corners, and nothing has to be rounded outwards.
class FloatVertices {
 public:
  void set(const std::vector<Point3>& vertices) {
    vertices_.resize(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) vertices_[v] = rounded(vertices[v]);
  }
  // In another order, order[v] becoming v, and moved, in float: each coordinate is off by up to six roundings of
  // numbers of the size of a vertex and the translation.
  void set(const std::vector<Point3>& vertices, const std::vector<int>& order, const RigidTransform<double>& by) {
    const auto turned = [&](const Point3& p) { return rounded(rotate<double>(by.rotation, p)); };
    const Row<float, 4> x = turned(Point3::UnitX()), y = turned(Point3::UnitY()), z = turned(Point3::UnitZ()),
                        t = rounded(by.translation);
    vertices_.resize(order.size());
    for (std::size_t v = 0; v < order.size(); ++v) {
      const Point3& p = vertices[order[v]];
      vertices_[v] = x * float(p[0]) + y * float(p[1]) + z * float(p[2]) + t;
    }
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
