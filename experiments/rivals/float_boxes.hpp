// Boxes of triangles in float, for engines that have no double and for SIMD lanes.
#pragma once

#include "algorithms/model/model.hpp"

namespace refitlab {

struct FloatBox {
  Eigen::Array4f low, high;  // the fourth numbers are 0
};

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
    const Eigen::Array4f x = turned(Point3::UnitX()), y = turned(Point3::UnitY()), z = turned(Point3::UnitZ()),
                         t = rounded(by.translation);
    vertices_.resize(order.size());
    for (std::size_t v = 0; v < order.size(); ++v) {
      const Point3& p = vertices[order[v]];
      vertices_[v] = x * float(p[0]) + y * float(p[1]) + z * float(p[2]) + t;
    }
  }
  FloatBox box(const Triangle& t) const {
    const Eigen::Array4f &a = vertices_[t[0]], &b = vertices_[t[1]], &c = vertices_[t[2]];
    return {a.min(b).min(c), a.max(b).max(c)};
  }

 private:
  static Eigen::Array4f rounded(const Point3& p) { return {float(p[0]), float(p[1]), float(p[2]), 0}; }

  std::vector<Eigen::Array4f> vertices_;
};

}  // namespace refitlab
