// SPDX-License-Identifier: GPL-3.0-or-later
// A body is an implicit surface, made of smooth unions and differences of simple parts, which are given by signed distance.
#pragma once

#include <functional>

#include "algorithms/model/model.hpp"

namespace refitlab {

// A Distance is that to the surface of a part, in metres. It is negative inside, and Euclidean or close to it.
using Distance = std::function<double(const Point3&)>;

class ImplicitBody {
 public:
  // Each call joins a part to what is there already, rounding the seam within about `blend` of it.
  void add_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend);  // hull of two balls
  void add_ellipsoid(const Point3& center, const Point3& radii, double blend);                      // along the axes
  void add_membrane(const Point3& a, const Point3& b, const Point3& c, double half_thickness, double blend);
  void carve_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend);

  double distance(const Point3& p) const;  // negative inside
  Point3 normal(const Point3& p) const;    // unit, outward: the gradient of the distance
  Point3 project(const Point3& p) const;   // a point of the surface near p, for p near the surface

  const Point3& low() const { return low_; }  // corners of a box that holds the body
  const Point3& high() const { return high_; }

 private:
  struct Part {
    Distance distance;
    double blend;
    bool carved;
    Point3 center;  // of a ball that holds the part
    double radius;
  };
  void add(const Part& part);

  std::vector<Part> parts_;
  Point3 low_ = Point3::Constant(1e9), high_ = Point3::Constant(-1e9);
};

// Returns the mirror image on the other side of the plane x = 0.
Point3 mirrored(const Point3& p);

// Joins a part of the left side, and its mirror image of the right side.
struct Sides {
  ImplicitBody& body;
  void add_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend);
  void add_ellipsoid(const Point3& center, const Point3& radii, double blend);
  void add_membrane(const Point3& a, const Point3& b, const Point3& c, double half_thickness, double blend);
  void carve_cone(const Point3& a, double radius_a, const Point3& b, double radius_b, double blend);
};

}  // namespace refitlab
