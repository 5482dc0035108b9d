// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the drawings of the lemmas show what the lemmas compute.
#include "experiments/drawings/drawings.hpp"

#include <algorithm>
#include <cmath>

#include "proptests/harness/harness.hpp"

namespace proptests::suite_drawings {
namespace {

using namespace refitlab;
using drawings::Plane, drawings::Point, drawings::Shape;

void caps(Suite& t) {
  t.example("a cap is drawn from one end of its rim over its apex to the other", {.number_type = "double"}, [] {
    long tried = 0, wrong = 0;
    const Point center(0.5, -1);
    for (const double cosine : {-1.0, -0.6, -0.1, 0.0, 0.3, 0.9, 1.0})
      for (const Point& axis : {Point(1, 0), Point(-0.3, 2), Point(0.1, -0.05)}) {
        Plane plane;
        plane.cap({center, center + axis, cosine});
        const std::vector<Point>& points = plane.shapes().at(0).points;
        const double squared = axis.squaredNorm();
        const auto cosine_at = [&](const Point& p) { return axis.dot(p - center) / squared; };
        const auto side_at = [&](const Point& p) { return (axis[0] * (p - center)[1] - axis[1] * (p - center)[0]) / squared; };
        const double sine = std::sqrt(1 - cosine * cosine);
        for (const Point& end : {points.front(), points.back()})
          wrong += std::abs(cosine_at(end) - cosine) > 1e-12 || std::abs(std::abs(side_at(end)) - sine) > 1e-7;
        wrong += side_at(points.front()) > 1e-12 || side_at(points.back()) < -1e-12;
        wrong += (points[points.size() / 2] - center - axis).norm() > 1e-12;
        for (const Point& p : points)
          wrong += std::abs((p - center).squaredNorm() / squared - 1) > 1e-12 || cosine_at(p) < cosine - 1e-12;
        ++tried;
      }
    return Checked(wrong == 0, tried, std::to_string(wrong) + " are wrong");
  });
  t.example(
      "in the drawing of Lemma 5 the repaired ball holds the cap, and the printed one does not", {.number_type = "double"}, [] {
        for (const drawings::Drawing& drawing : drawings::all_drawings()) {
          if (drawing.stem != "lemma5_cap_enclosing_sphere") continue;
          Plane plane;
          drawing.draw(plane);
          const auto of_kind = [&](const std::string& kind) {
            return *std::find_if(plane.shapes().begin(), plane.shapes().end(), [&](const Shape& s) { return s.kind == kind; });
          };
          const Shape cap = of_kind("cap"), repaired = of_kind("ball"), printed = of_kind("printed");
          const auto outside = [&](const Shape& circle) {
            return std::count_if(cap.points.begin(), cap.points.end(),
                                 [&](const Point& p) { return (p - circle.points[0]).norm() > circle.radius + 1e-12; });
          };
          return Checked(outside(repaired) == 0 && outside(printed) > 0, static_cast<long>(cap.points.size()));
        }
        return Checked(false, 0, "there is no such drawing");
      });
}

void all_drawings(Suite& t) {
  t.example("every drawing has a caption, and shapes of finite numbers", {.number_type = "double"}, [] {
    long tried = 0;
    std::string wrong;
    for (const drawings::Drawing& drawing : drawings::all_drawings()) {
      Plane plane;
      drawing.draw(plane);
      if (drawing.caption.empty() || plane.shapes().empty()) wrong += drawing.stem + " is empty; ";
      for (const Shape& shape : plane.shapes()) {
        const bool is_finite =
            std::all_of(shape.points.begin(), shape.points.end(), [](const Point& p) { return p.allFinite(); });
        const std::size_t least = shape.shape == "path" ? 2 : 1;
        if (!is_finite || !(shape.radius >= 0 && std::isfinite(shape.radius)) || shape.points.size() < least)
          wrong += drawing.stem + ": " + shape.shape + " " + shape.kind + "; ";
        ++tried;
      }
    }
    return Checked(wrong.empty() && tried > 100, tried, wrong);
  });
}

}  // namespace

PROPTEST(drawings) {
  caps(t);
  all_drawings(t);
}

}  // namespace proptests::suite_drawings
