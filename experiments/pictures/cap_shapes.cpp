// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/cap_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace refitlab {
namespace {

constexpr int around = 96, across = 32;

// Returns a surface of revolution about an axis. at(share, u, v) is its point for shares 0 to 1 from the axis outwards, where u
// and v are a frame across the axis.
template <class At>
render::MeshShape revolution(const Point3& axis, render::Color color, const At& at) {
  const Point3 u = axis.unitOrthogonal(), v = axis.normalized().cross(u);
  render::MeshShape mesh;
  mesh.color = color;
  for (int i = 0; i <= across; ++i)
    for (int k = 0; k < around; ++k) {
      const double turn = 2 * std::numbers::pi * k / around;
      mesh.vertices.push_back(at(static_cast<double>(i) / across, Point3(std::cos(turn) * u + std::sin(turn) * v)));
    }
  for (int i = 0; i < across; ++i)
    for (int k = 0; k < around; ++k) {
      const int a = i * around + k, b = i * around + (k + 1) % around;
      mesh.triangles.push_back({a, a + around, b + around});
      mesh.triangles.push_back({a, b + around, b});
    }
  return mesh;
}

}  // namespace

render::MeshShape cap_shape(const Cap<double, 3>& cap, render::Color color) {
  const Point3 to_apex = cap.apex - cap.center;
  const double angle = std::acos(std::clamp(cap.cos_angle, -1., 1.)), radius = 1.004 * to_apex.norm();
  return revolution(to_apex, color, [&](double share, const Point3& out) -> Point3 {
    return cap.center + radius * (std::cos(share * angle) * to_apex.normalized() + std::sin(share * angle) * out);
  });
}

render::MeshShape border_shape(const HalfSpace<double, 3>& h, double radius, render::Color color) {
  const Point3 foot = h.normal * (h.offset / h.normal.squaredNorm());
  return revolution(h.normal, color, [&](double share, const Point3& out) -> Point3 { return foot + share * radius * out; });
}

}  // namespace refitlab
