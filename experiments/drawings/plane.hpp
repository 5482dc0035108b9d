// SPDX-License-Identifier: GPL-3.0-or-later
// A Plane is a picture in the plane as a list of shapes, for the report to draw (experiments/report/drawings.py). y is up.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace refitlab::drawings {

using Point = Vec<double, 2>;

// kind is the class that the report's style sheet (drawings.css) gives a line, a filling or a mark.
struct Shape {
  std::string shape;  // "circle", "path", "dot" or "text"
  std::string kind;
  std::vector<Point> points;  // of a path; else one
  double radius = 0;          // of a circle
  bool closed = false;        // a path
  std::string label = "";     // beside a dot, or a text
};

class Plane {
 public:
  void circle(const std::string& kind, const Point& center, double radius) {
    shapes_.push_back({"circle", kind, {center}, radius});
  }
  void ball(const std::string& kind, const SquaredBall<double, 2>& b) {
    circle(kind, b.center, std::sqrt(std::max(0., b.squared_radius)));
  }
  void path(const std::string& kind, const std::vector<Point>& points, bool closed = false) {
    shapes_.push_back({"path", kind, points, 0, closed});
  }
  void dot(const std::string& kind, const Point& at, const std::string& label = "") {
    shapes_.push_back({"dot", kind, {at}, 0, false, label});
  }
  void text(const Point& at, const std::string& words) { shapes_.push_back({"text", "", {at}, 0, false, words}); }
  // Draws the points of the cap's circle that the cap holds.
  void cap(const Cap<double, 2>& c) {
    std::vector<Point> arc;
    const Point axis = c.apex - c.center;
    const double angle = std::acos(std::clamp(c.cos_angle, -1., 1.));
    for (int i = -40; i <= 40; ++i) arc.push_back(c.center + turned(axis, angle * i / 40));
    path("cap", arc);
  }
  void border(const HalfSpace<double, 2>& h) {
    const Point foot = h.normal * (h.offset / squared_norm(h.normal)), along = turned(h.normal.normalized(), 1.5707963267948966);
    path("plane", {foot - along * 1.3, foot + along * 1.3});
    path("plane", {foot, foot + h.normal.normalized() * 0.2});
  }

  static Point turned(const Point& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
  }

  const std::vector<Shape>& shapes() const { return shapes_; }

 private:
  std::vector<Shape> shapes_;
};

}  // namespace refitlab::drawings
