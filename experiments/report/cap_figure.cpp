#include "experiments/report/cap_figure.hpp"

#include "algorithms/balls/mean_ball.hpp"
#include "experiments/drawings/drawings.hpp"
#include "experiments/report/cap_shapes.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

namespace refitlab {
namespace {

using render::Scene;
namespace palette = render::palette;

constexpr int width = 480, height = 440;
const SquaredBall<double, 3> unit_sphere{{0, 0, 0}, 1};
const Point3 above(0.35, 1, 0.25);  // where the caps are

Ball3<double> ball_of(const SquaredBall<double, 3>& b) { return {b.center, std::sqrt(b.squared_radius)}; }

struct Drawn {
  Scene scene;
  std::vector<Label> labels;
  void dot(const Point3& at, const std::string& label, render::Color color = palette::black) {
    scene.balls.push_back({{at, 0.03}, color, 1});
    if (!label.empty()) labels.push_back({at, label});
  }
  void cap(const Cap<double, 3>& c) {
    scene.meshes.push_back(cap_shape(c, palette::orange));
    scene.meshes.back().opacity = 0.4;
  }
  void surface() { scene.balls.push_back({ball_of(unit_sphere), palette::gray, 0.12}); }
  void border(const HalfSpace<double, 3>& h) {
    scene.meshes.push_back(border_shape(h, 1.15, palette::green));
    scene.meshes.back().opacity = 0.35;
  }
  Picture picture(const std::string& caption, const std::string& path) const {
    const auto camera = render::Camera::orthographic({1, 1.1, 4}, {0, 0, 0}, 3);
    return rendered(scene, camera, {.width = width, .height = height}, caption, path, labels);
  }
};

Picture half_space_and_cap(const std::string& path) {
  const HalfSpace<double, 3> h{above, 0.5 * above.norm()};
  const auto cap = cap_of_half_space_by_root(unit_sphere, h).cap;
  Drawn d;
  d.surface();
  d.border(h);
  d.cap(cap);
  d.scene.lines.push_back({{{0, 0, 0}, cap.apex}, 0.012, palette::black});
  d.dot({0, 0, 0}, "c"), d.dot(cap.apex, "a");
  return d.picture(
      "Figure 2 in space: the half-space (its border green) cuts the cap (orange) with center c and apex a.", path);
}

Picture ball_and_cap(const std::string& path) {
  const std::vector<Point3> units{Point3(0.75, 1, 0.3).normalized(), Point3(-0.5, 0.9, 0.5).normalized(),
                                  Point3(0.4, 0.8, -0.6).normalized(), Point3(0.2, 0.7, 0.9).normalized()};
  const auto ball = mean_ball<double, 3>(std::span<const Point3>(units));
  const auto h = intersection_cap(unit_sphere, squared(ball)).half_space;
  Drawn d;
  d.surface();
  d.border(h);
  d.cap(cap_of_half_space_by_root(unit_sphere, h).cap);
  d.scene.balls.push_back({ball, palette::blue, 0.18});
  for (std::size_t i = 0; i < units.size(); ++i) d.dot(1.01 * units[i], "q" + std::to_string(i + 1));
  d.dot({0, 0, 0}, "0");
  return d.picture(
      "Figure 3 in space: unit vectors q, their mean ball E (blue), the cap E ∩ S (orange) and its half-space H "
      "(border "
      "green).",
      path);
}

Picture cap_and_ball(double cosine, bool printed, const std::string& caption, const std::string& path) {
  const Cap<double, 3> cap{{0, 0, 0}, above.normalized(), cosine};
  Drawn d;
  d.surface();
  d.cap(cap);
  const auto ball = printed ? cap_ball_printed(cap) : cap_ball_repaired(cap);
  const bool holds = norm<double, 3>(cap.apex - ball.center) <= std::sqrt(ball.squared_radius) + 1e-12;
  d.scene.balls.push_back({ball_of(ball), printed ? palette::vermillion : palette::blue, 0.22});
  d.dot(1.01 * cap.apex, holds ? "apex" : "apex, outside", holds ? palette::black : palette::vermillion);
  d.dot(ball.center, "center of F");
  return d.picture(caption, path);
}

}  // namespace

Figure cap_figure(const std::string& folder) {
  Figure out{"Caps, half-spaces and balls (the paper's Figures 2, 3 and 4)",
             "In the plane and in space (the paper’s S₃ is one dimension further), drawn from what the code of Lemmas "
             "1, 3, 4 and 5 "
             "computes.",
             {},
             {},
             3,
             1};
  for (const char* stem : {"lemma1_cap_definitions", "lemma4_quaternion_hull", "lemma5_cap_enclosing_sphere"}) {
    const auto drawing = drawings::drawing_of(stem);
    out.pictures.push_back({drawing.caption, drawing.svg()});
  }
  out.pictures.push_back(half_space_and_cap(folder + "/figure2.png"));
  out.pictures.push_back(ball_and_cap(folder + "/figure3.png"));
  out.pictures.push_back(cap_and_ball(0.5, false, "Figure 4 in space: a cap (orange) and its smallest ball F (blue).",
                                      folder + "/figure4.png"));
  out.pictures.push_back(cap_and_ball(
      -0.6, true,
      "Where Lemma 5 fails: the angle is beyond 90°, and the printed ball (vermillion) leaves out the apex.",
      folder + "/figure4_printed.png"));
  out.pictures.push_back(cap_and_ball(-0.6, false, "Repaired: the ball of such a cap is that of the whole sphere.",
                                      folder + "/figure4_repaired.png"));
  return out;
}

}  // namespace refitlab
