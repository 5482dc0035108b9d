// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/camera.hpp"

#include <numbers>

namespace refitlab::render {
namespace {

double height_at_one(double field_of_view) { return 2 * std::tan(field_of_view / 360 * std::numbers::pi); }

}  // namespace

Camera::Camera(const Point3& eye, const Point3& back, const Point3& up, double field_of_view, double height)
    : eye_(eye),
      field_of_view_(field_of_view),
      height_(height) {
  back_ = back.normalized();
  right_ = up.cross(back_);
  if (!eye.allFinite() || !(back.norm() > 0) || !(right_.norm() > 1e-9 * up.norm()))
    throw std::invalid_argument("camera: the eye must be finite and the view direction neither zero nor along up");
  if (!(field_of_view >= 0 && field_of_view < 180) || !(height > 0) || !std::isfinite(height))
    throw std::invalid_argument("camera: the field of view must be in (0, 180) degrees and the height positive");
  right_.normalize();
  up_ = back_.cross(right_);
}

Camera Camera::perspective(const Point3& eye, const Point3& target, double field_of_view, const Point3& up) {
  return Camera(eye, eye - target, up, field_of_view, height_at_one(field_of_view));
}

Camera Camera::orthographic(const Point3& eye, const Point3& target, double height, const Point3& up) {
  return Camera(eye, eye - target, up, 0, height);
}

Camera Camera::frame(const Box<double>& box, const Point3& from, double aspect, double field_of_view, double margin,
                     const Point3& up) {
  if (box.is_empty()) throw std::invalid_argument("camera: nothing to frame, the box is empty");
  const Point3 center = box.center();
  const double half_diagonal = std::max(box.edges().norm() / 2, 1e-6);
  const double room = 1 - 2 * margin;
  const double slope = height_at_one(field_of_view) / 2 * room;
  Camera camera(center, from, up, field_of_view, 1);
  double half_height = 1e-6, distance = 0;
  for (int i = 0; i < 8; ++i) {
    Point3 corner = -center;
    for (int k = 0; k < 3; ++k) corner[k] += (i >> k & 1 ? box.high : box.low)[k];
    const double reach = std::max(std::abs(corner.dot(camera.up_)), std::abs(corner.dot(camera.right_)) / aspect);
    half_height = std::max(half_height, reach / room);
    if (field_of_view > 0) distance = std::max(distance, reach / slope + corner.dot(camera.back_));
  }
  camera.eye_ = center + camera.back_ * (field_of_view > 0 ? distance : 2 * half_diagonal);
  camera.height_ = field_of_view > 0 ? height_at_one(field_of_view) : 2 * half_height;
  return camera;
}

Camera Camera::frame(std::span<const Point3> points, const Point3& from, double aspect, double margin, const Point3& up) {
  if (points.empty()) throw std::invalid_argument("camera: nothing to frame, there are no points");
  Camera camera(points[0], from, up, 0, 1);
  auto seen = Box<double>::empty();  // in the camera's own frame
  for (const Point3& p : points) seen.merge(Point3(p.dot(camera.right_), p.dot(camera.up_), p.dot(camera.back_)));
  const Point3 size = seen.edges(), center = seen.center();
  camera.height_ = std::max({size.y(), size.x() / aspect, 1e-6}) / (1 - 2 * margin);
  camera.eye_ = center.x() * camera.right_ + center.y() * camera.up_ + (center.z() + size.z() + camera.height_) * camera.back_;
  return camera;
}

Ray Camera::ray(double x, double y) const {
  const Point3 offset = height_ * (x * right_ + y * up_);
  if (field_of_view_ > 0) return {eye_, (offset - back_).normalized()};
  return {eye_ + offset, -back_};
}

Vec<double, 2> Camera::project(const Point3& point, int width, int height) const {
  const Point3 p = point - eye_;
  const double scale = height / extent(-p.dot(back_));
  return {width / 2.0 + scale * p.dot(right_), height / 2.0 - scale * p.dot(up_)};
}

}  // namespace refitlab::render
