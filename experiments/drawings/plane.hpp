// Plane: a picture in the plane as SVG. Its classes are those of drawings/style.hpp; y is up.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace refitlab::drawings {

using Point = Vec<double, 2>;

class Plane {
 public:
  void circle(const char* kind, const Point& center, double radius) {
    out_ << "<circle class=\"" << kind << "\" cx=\"" << x(center) << "\" cy=\"" << y(center) << "\" r=\""
         << scale * radius << "\"/>\n";
    grow(center, radius);
  }
  void ball(const char* kind, const SquaredBall<double, 2>& b) {
    circle(kind, b.center, std::sqrt(std::max(0., b.squared_radius)));
  }
  void path(const char* kind, const std::vector<Point>& points, bool closed = false) {
    out_ << "<path class=\"" << kind << "\" d=\"";
    for (std::size_t i = 0; i < points.size(); ++i)
      out_ << (i ? "L" : "M") << x(points[i]) << ' ' << y(points[i]), grow(points[i], 0);
    out_ << (closed ? "Z" : "") << "\"" << (closed ? "" : " fill=\"none\"") << "/>\n";
  }
  void dot(const char* kind, const Point& at, const std::string& label = "") {
    out_ << "<circle class=\"" << kind << "\" cx=\"" << x(at) << "\" cy=\"" << y(at) << "\" r=\"4\"/>\n";
    if (!label.empty()) labels_ << "<text x=\"" << x(at) + 7 << "\" y=\"" << y(at) - 7 << "\">" << label << "</text>\n";
    grow(at, 0.12);
  }
  void text(const Point& at, const std::string& words) {
    labels_ << "<text x=\"" << x(at) << "\" y=\"" << y(at) << "\">" << words << "</text>\n";
    grow(at, 0.1);
  }
  // The points of the cap's circle that the cap holds.
  void cap(const Cap<double, 2>& c) {
    std::vector<Point> arc;
    const Point axis = c.apex - c.center;
    const double angle = std::acos(std::clamp(c.cos_angle, -1., 1.));
    for (int i = -40; i <= 40; ++i) arc.push_back(c.center + turned(axis, angle * i / 40));
    path("cap", arc);
  }
  void border(const HalfSpace<double, 2>& h) {
    const Point foot = h.normal * (h.offset / squared_norm(h.normal)),
                along = turned(h.normal.normalized(), 1.5707963267948966);
    path("plane", {foot - along * 1.3, foot + along * 1.3});
    path("plane", {foot, foot + h.normal.normalized() * 0.2});
  }

  static Point turned(const Point& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
  }

  // The title is the picture's caption, for who does not see it.
  std::string svg(const std::string& title) const {
    std::ostringstream out;
    const double margin = 20, width = high_[0] - low_[0], height = high_[1] - low_[1];
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" role=\"img\" aria-label=\"" << title
        << "\" viewBox=\"" << scale * low_[0] - margin << ' ' << -scale * high_[1] - margin << ' '
        << scale * width + 3 * margin << ' ' << scale * height + 2 * margin << "\">\n"
        << out_.str() << labels_.str() << "</svg>\n";
    return out.str();
  }

 private:
  static constexpr double scale = 120;
  static double x(const Point& p) { return scale * p[0]; }
  static double y(const Point& p) { return -scale * p[1]; }
  void grow(const Point& p, double r) {
    low_ = low_.cwiseMin(Point(p[0] - r, p[1] - r)), high_ = high_.cwiseMax(Point(p[0] + r, p[1] + r));
  }

  std::ostringstream out_, labels_;
  Point low_{1e9, 1e9}, high_{-1e9, -1e9};
};

}  // namespace refitlab::drawings
