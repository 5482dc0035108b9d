// SPDX-License-Identifier: GPL-3.0-or-later
// A Camera says from where, towards where, and which way is up.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/balls/box.hpp"

namespace refitlab::render {

// A Ray is a half-line. direction has unit length.
struct Ray {
  Point3 origin, direction;
};

// A Camera is orthographic, and in model space, right-handed, whose y is up in the picture. In the picture plane x is right and y
// is up, seen along -z of the camera's own frame.
class Camera {
 public:
  // height is what the picture's height covers, in model units. Throws std::invalid_argument if there is no such camera (eye =
  // target, y along the view, not finite).
  static Camera orthographic(const Point3& eye, const Point3& target, double height);

  // Returns a camera that sees all of the points, centred, with no more space around them than the margin, which is the empty
  // share at each side. from is the direction from the points to the eye, of any length. aspect is width / height of the picture.
  static Camera frame(std::span<const Point3> points, const Point3& from, double aspect, double margin);

  // Returns the ray through the point (x, y) of the picture, in units of its height. (0, 0) is its centre, and y = 1/2 its upper
  // edge.
  Ray ray(double x, double y) const;

  // Returns where a point is seen, in pixels from the upper left corner, for labels drawn over the picture.
  Vec<double, 2> project(const Point3& point, int width, int height) const;

  double height() const { return height_; }  // of the picture, in model units

  const Point3& right() const { return right_; }
  const Point3& up() const { return up_; }
  const Point3& back() const { return back_; }  // from the target to the eye

 private:
  Camera(const Point3& eye, const Point3& back, double height);
  Point3 eye_, right_, up_, back_;
  double height_;
};

}  // namespace refitlab::render
