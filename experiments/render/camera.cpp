// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/camera.hpp"

namespace refitlab::render {

Camera::Camera(const Point3& eye, const Point3& back, double height) : eye_(eye), height_(height) {
  const Point3 up(0, 1, 0);
  back_ = back.normalized();
  right_ = up.cross(back_);
  if (!eye.allFinite() || !(back.norm() > 0) || !(right_.norm() > 1e-9))
    throw std::invalid_argument("camera: the eye must be finite and the view direction neither zero nor along up");
  if (!(height > 0) || !std::isfinite(height)) throw std::invalid_argument("camera: the height must be positive and finite");
  right_.normalize();
  up_ = back_.cross(right_);
}

Camera Camera::orthographic(const Point3& eye, const Point3& target, double height) { return Camera(eye, eye - target, height); }

Camera Camera::frame(std::span<const Point3> points, const Point3& from, double aspect, double margin) {
  if (points.empty()) throw std::invalid_argument("camera: nothing to frame, there are no points");
  Camera camera(points[0], from, 1);
  auto seen = Box<double>::empty();  // in the camera's own frame
  for (const Point3& p : points) seen.merge(Point3(p.dot(camera.right_), p.dot(camera.up_), p.dot(camera.back_)));
  const Point3 size = seen.edges(), center = seen.center();
  camera.height_ = std::max({size.y(), size.x() / aspect, 1e-6}) / (1 - 2 * margin);
  camera.eye_ = center.x() * camera.right_ + center.y() * camera.up_ + (center.z() + size.z() + camera.height_) * camera.back_;
  return camera;
}

Ray Camera::ray(double x, double y) const { return {eye_ + height_ * (x * right_ + y * up_), -back_}; }

Vec<double, 2> Camera::project(const Point3& point, int width, int height) const {
  const Point3 p = point - eye_;
  const double scale = height / height_;
  return {width / 2.0 + scale * p.dot(right_), height / 2.0 - scale * p.dot(up_)};
}

}  // namespace refitlab::render
