// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/procedural/procedural_body.hpp"

#include <algorithm>
#include <cmath>

namespace refitlab {
namespace {

// A cone is the hull of two balls. In the plane through the axis, its distance is that to two arcs and the segment tangent to
// them.
Distance cone(const Point3& a, double radius_a, const Point3& b, double radius_b) {
  const Point3 axis = b - a;
  const double length = norm(axis);
  const double slope = length > 0 ? (radius_a - radius_b) / length : 1;
  if (std::abs(slope) >= 1) {  // one ball holds the other
    const Point3 center = radius_a >= radius_b ? a : b;
    const double radius = std::max(radius_a, radius_b);
    return [=](const Point3& p) { return norm(Point3(p - center)) - radius; };
  }
  const Point3 direction = axis / length;
  const double rise = std::sqrt(1 - slope * slope);
  return [=](const Point3& p) {
    const Point3 from_a = p - a;
    const double along = dot(from_a, direction);
    const double away = norm(Point3(from_a - along * direction));
    const double foot = along + away * slope / rise;  // where the surface normal through p meets the axis
    if (foot <= 0) return std::sqrt(sq(along) + sq(away)) - radius_a;
    if (foot >= length) return std::sqrt(sq(along - length) + sq(away)) - radius_b;
    return along * slope + away * rise - radius_a;
  };
}

// This distance is of first order: it is exact on the surface and has the right sign everywhere.
Distance ellipsoid(const Point3& center, const Point3& radii) {
  return [=](const Point3& p) {
    const Point3 scaled = (p - center).cwiseQuotient(radii);
    const double level = norm(scaled);
    const double gradient = norm(Point3(scaled.cwiseQuotient(radii)));
    return gradient > 0 ? level * (level - 1) / gradient : -radii.minCoeff();
  };
}

Point3 nearest_on_segment(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 ab = b - a;
  return a + std::clamp(dot(Point3(p - a), ab) / squared_norm(ab), 0., 1.) * ab;
}

Distance membrane(const Point3& a, const Point3& b, const Point3& c, double half_thickness) {
  const std::array<Point3, 3> vertices = {a, b, c};
  const Point3 normal = cross(Point3(b - a), Point3(c - a)).normalized();
  return [=](const Point3& p) {
    bool above = true;  // the foot of the perpendicular lies in the triangle
    double nearest = 1e9;
    for (int i = 0; i < 3; ++i) {
      const Point3 &from = vertices[i], &to = vertices[(i + 1) % 3];
      above = above && dot(cross(normal, Point3(to - from)), Point3(p - from)) >= 0;
      nearest = std::min(nearest, norm(Point3(p - nearest_on_segment(p, from, to))));
    }
    return (above ? std::abs(dot(normal, Point3(p - a))) : nearest) - half_thickness;
  };
}

// Returns min(a, b), lowered by up to blend / 4 where the two differ by less than blend.
double smooth_min(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.) / blend;
  return std::min(a, b) - overlap * overlap * blend / 4;
}

}  // namespace

void ImplicitBody::add_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend) {
  const double reach = norm(Point3(b - a)) / 2 + std::max(radius_a, radius_b);
  add({cone(a, radius_a, b, radius_b), blend, false, (a + b) / 2, reach});
}

void ImplicitBody::add_ellipsoid(const Point3& center, const Point3& radii, double blend) {
  add({ellipsoid(center, radii), blend, false, center, radii.maxCoeff()});
}

void ImplicitBody::add_membrane(const Point3& a, const Point3& b, const Point3& c, double half_thickness, double blend) {
  const Point3 center = (a + b + c) / 3;
  double reach = 0;
  for (const Point3& vertex : {a, b, c}) reach = std::max(reach, norm(Point3(vertex - center)));
  add({membrane(a, b, c, half_thickness), blend, false, center, reach + half_thickness});
}

void ImplicitBody::carve_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend) {
  const double reach = norm(Point3(b - a)) / 2 + std::max(radius_a, radius_b);
  parts_.push_back({cone(a, radius_a, b, radius_b), blend, true, (a + b) / 2, reach});
}

void ImplicitBody::add(const Part& part) {
  low_ = low_.cwiseMin(part.center - Point3::Constant(part.radius + part.blend));
  high_ = high_.cwiseMax(part.center + Point3::Constant(part.radius + part.blend));
  parts_.push_back(part);
}

double ImplicitBody::distance(const Point3& p) const {
  double d = 1e9;
  for (const Part& part : parts_) {
    const double other = part.carved ? -d : d;
    // Such a part is too far away to matter. The 2 makes up for parts whose distance is approximate.
    if (squared_distance<double, 3>(p, part.center) > sq(part.radius + 2 * (part.blend + std::max(other, 0.)))) continue;
    const double joined = smooth_min(other, part.distance(p), part.blend);
    d = part.carved ? -joined : joined;
  }
  return d;
}

Point3 ImplicitBody::normal(const Point3& p) const {
  constexpr double step = 1e-4;
  Point3 gradient = Point3::Zero();
  // The gradient comes from differences along the four directions of a regular tetrahedron, which sum to zero.
  for (const Point3& direction : {Point3(1, -1, -1), Point3(-1, -1, 1), Point3(-1, 1, -1), Point3(1, 1, 1)})
    gradient += direction * distance(p + step * direction);
  return gradient.normalized();
}

Point3 ImplicitBody::project(const Point3& p) const {
  Point3 q = p;
  for (int i = 0; i < 4; ++i) {
    const double d = distance(q);
    if (std::abs(d) < 1e-5) break;
    q -= d * normal(q);
  }
  return q;
}

Point3 mirrored(const Point3& p) { return {-p[0], p[1], p[2]}; }

void Sides::add_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend) {
  body.add_cone(a, radius_a, b, radius_b, blend);
  body.add_cone(mirrored(a), radius_a, mirrored(b), radius_b, blend);
}

void Sides::add_ellipsoid(const Point3& center, const Point3& radii, double blend) {
  body.add_ellipsoid(center, radii, blend);
  body.add_ellipsoid(mirrored(center), radii, blend);
}

void Sides::add_membrane(const Point3& a, const Point3& b, const Point3& c, double half_thickness, double blend) {
  body.add_membrane(a, b, c, half_thickness, blend);
  body.add_membrane(mirrored(a), mirrored(b), mirrored(c), half_thickness, blend);
}

void Sides::carve_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend) {
  body.carve_cone(a, radius_a, b, radius_b, blend);
  body.carve_cone(mirrored(a), radius_a, mirrored(b), radius_b, blend);
}

}  // namespace refitlab
