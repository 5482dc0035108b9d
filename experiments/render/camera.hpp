// SPDX-License-Identifier: GPL-3.0-or-later
// Camera: from where, towards where, and which way is up.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/balls/box.hpp"

namespace refitlab::render {

// A half-line; direction is of unit length.
struct Ray {
  Point3 origin, direction;
};

// Model space, right-handed. The picture plane is x right, y up, seen along -z of the camera's own frame.
class Camera {
 public:
  // field_of_view: of the picture's height, in degrees, in (0, 180). Throws std::invalid_argument if there is no such
  // camera (eye = target, up along the view, not finite).
  static Camera perspective(const Point3& eye, const Point3& target, double field_of_view = 30, const Point3& up = {0, 1, 0});
  // height: what the picture's height covers, in model units.
  static Camera orthographic(const Point3& eye, const Point3& target, double height, const Point3& up = {0, 1, 0});

  // Sees all of the box, centred. from: the direction from the box to the eye, any length. aspect: width / height of
  // the picture. field_of_view 0 asks for an orthographic camera. margin: empty share at each side.
  static Camera frame(const Box<double>& box, const Point3& from, double aspect = 1, double field_of_view = 0,
                      double margin = 0.04, const Point3& up = {0, 1, 0});

  // Orthographic; sees all of the points, centred, with no more room than the margin.
  static Camera frame(std::span<const Point3> points, const Point3& from, double aspect = 1, double margin = 0.04,
                      const Point3& up = {0, 1, 0});

  // Through the point (x, y) of the picture, in units of its height: (0, 0) its centre, y = 1/2 its upper edge.
  Ray ray(double x, double y) const;

  // Where a point is seen, in pixels from the upper left corner, for labels drawn over the picture.
  Vec<double, 2> project(const Point3& point, int width, int height) const;

  // What one unit of the picture (its height) covers in model units at a distance along a ray.
  double extent(double distance) const { return field_of_view_ > 0 ? height_ * distance : height_; }

  const Point3& right() const { return right_; }
  const Point3& up() const { return up_; }
  const Point3& back() const { return back_; }  // from the target to the eye

 private:
  Camera(const Point3& eye, const Point3& back, const Point3& up, double field_of_view, double height);
  Point3 eye_, right_, up_, back_;
  double field_of_view_;  // degrees; 0 if orthographic
  double height_;         // of the picture: at distance 1 if perspective, anywhere if orthographic; model units
};

}  // namespace refitlab::render
