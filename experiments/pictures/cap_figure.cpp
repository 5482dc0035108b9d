// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/cap_figure.hpp"

#include "algorithms/runtime/balls/mean_ball.hpp"
#include "experiments/pictures/cap_shapes.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

namespace refitlab {
namespace {

using render::Scene;
namespace palette = render::palette;

constexpr int caps_width = 480, caps_height = 440;
const SquaredBall<double, 3> unit_sphere{{0, 0, 0}, 1};
const Point3 above(0.35, 1, 0.25);  // where the caps are

Ball3<double> ball_of(const SquaredBall<double, 3>& b) { return {b.center, std::sqrt(b.squared_radius)}; }

struct Drawn {
  Scene scene;
  std::vector<PictureLabel> labels;
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
  void draw(PictureTable& pictures, const std::string& name) const {
    const auto camera = render::Camera::orthographic({1, 1.1, 4}, {0, 0, 0}, 3);
    pictures.draw(scene, camera, {.width = caps_width, .height = caps_height}, {"caps", "", "", ""}, name + ".png", {}, labels);
  }
};

void half_space_and_cap(PictureTable& pictures) {
  const HalfSpace<double, 3> h{above, 0.5 * above.norm()};
  const auto cap = cap_of_half_space_by_root(unit_sphere, h).cap;
  Drawn d;
  d.surface();
  d.border(h);
  d.cap(cap);
  d.scene.lines.push_back({{{0, 0, 0}, cap.apex}, 0.012, palette::black});
  d.dot({0, 0, 0}, "c"), d.dot(cap.apex, "a");
  d.draw(pictures, "figure2");
}

void ball_and_cap(PictureTable& pictures) {
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
  d.draw(pictures, "figure3");
}

void cap_and_ball(PictureTable& pictures, double cosine, bool printed, const std::string& name) {
  const Cap<double, 3> cap{{0, 0, 0}, above.normalized(), cosine};
  Drawn d;
  d.surface();
  d.cap(cap);
  const auto ball = printed ? cap_ball_printed(cap) : cap_ball_repaired(cap);
  const bool holds = norm<double, 3>(cap.apex - ball.center) <= std::sqrt(ball.squared_radius) + 1e-12;
  d.scene.balls.push_back({ball_of(ball), printed ? palette::vermillion : palette::blue, 0.22});
  d.dot(1.01 * cap.apex, holds ? "apex" : "apex, outside", holds ? palette::black : palette::vermillion);
  d.dot(ball.center, "center of F");
  d.draw(pictures, name);
}

}  // namespace

void draw_caps(PictureTable& pictures) {
  half_space_and_cap(pictures);
  ball_and_cap(pictures);
  cap_and_ball(pictures, 0.5, false, "figure4");
  cap_and_ball(pictures, -0.6, true, "figure4_printed");  // where Lemma 5 fails
  cap_and_ball(pictures, -0.6, false, "figure4_repaired");
}

}  // namespace refitlab
