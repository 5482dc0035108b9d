// SPDX-License-Identifier: GPL-3.0-or-later
// These are the drawings of the statements of the paper's section 4 that have no number.
#include "algorithms/bake/weight_vertices.hpp"
#include "experiments/drawings/common.hpp"
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/s43_distance_range.hpp"
#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/s43_rotated_cap.hpp"

namespace refitlab::drawings {
namespace {

// Returns the point of a triangle that stands for the weights of three joints.
Point in_triangle(const std::vector<double> &w) { return on_circle(90) * w[2] + on_circle(210) * w[0] + on_circle(330) * w[1]; }
const WeightBounds<double> box{{0.1, 0.15, 0.05}, {0.6, 0.5, 0.55}};
std::vector<Point> around_their_middle(std::vector<Point> points) {
  const Point middle = mean_center(std::span<const Point>(points));
  std::sort(points.begin(), points.end(), [&](const Point &a, const Point &b) {
    return std::atan2(a[1] - middle[1], a[0] - middle[0]) < std::atan2(b[1] - middle[1], b[0] - middle[0]);
  });
  return points;
}
void s41(Plane &p) {
  p.path("line", {in_triangle({1, 0, 0}), in_triangle({0, 1, 0}), in_triangle({0, 0, 1})}, true);
  std::vector<Point> weight_vertices;
  for (const auto &c : weight_vertices_or_simplex(box)) weight_vertices.push_back(in_triangle(c));
  p.path("hull", around_their_middle(weight_vertices), true);
  for (const Point &c : weight_vertices) p.dot("dot_in", c);
  p.text(in_triangle({1, 0, 0}), "w1 = 1"), p.text(in_triangle({0, 1, 0}), "w2 = 1"), p.text(in_triangle({0, 0, 1}), "w3 = 1");
}

std::vector<Point> deformed_centers() { return {{0, 0}, {1.6, 0.2}, {0.7, 1.3}}; }
std::vector<Point> weight_vertex_images_of_box() {
  return weight_vertex_images<double, 2>(weight_vertices_or_simplex(box), deformed_centers());
}
void s42(Plane &p) {
  p.path("line", deformed_centers(), true);
  p.path("hull", around_their_middle(weight_vertex_images_of_box()), true);
  for (const Point &r : deformed_centers()) p.dot("dot", r, "C r");
  for (const Point &r : weight_vertex_images_of_box()) p.dot("dot_in", r, "r'");
}

void s43_distance_range(Plane &p) {
  p.circle("surface", {0, 0}, 1);
  const Ball<double, 2> good{on_circle(20), 0.6}, bad{{3, 0}, 0.5};
  p.ball("ball", squared(good)), p.ball("printed", squared(bad));
  p.dot("dot_in", good.center, std::string("in range: ") + name_of(distance_range_repaired(good.center, good.radius)));
  p.dot("dot_out", bad.center, std::string("printed: ") + name_of(distance_range_printed(bad.center, bad.radius)));
}

void s43_minkowski_sum(Plane &p) {
  const Point3D center(1.2, 0, 0);
  std::vector<Point> path;
  for (int i = 0; i <= 20; ++i) path.push_back(flat(rotate_by<double>(turn(0) * (1 - i / 20.) + turn(120) * (i / 20.), center)));
  for (int i = 0; i <= 20; i += 5) p.circle("ball", path[i], 0.35);
  p.path("curve", path);
  p.dot("dot", {0, 0}, "r_c"), p.dot("dot", path[0], "p");
}

void s43_rotated_cap(Plane &p) {
  const double angle = 40;
  p.circle("surface", {0, 0}, 1);
  p.cap({{0, 0}, slice(turn(0)), std::cos(angle * std::numbers::pi / 180)});
  p.dot("dot", slice(turn(0)), "rotations");
  const double twice = rotated_cap_cosine_repaired(std::cos(angle * std::numbers::pi / 180));
  p.circle("surface", {3, 0}, 1);
  p.cap({{3, 0}, {4, 0}, twice});
  for (const double end : {-2 * angle, 2 * angle}) {
    p.dot("dot", slice(turn(end)), "q");
    p.dot("dot_in", Point(3, 0) + flat(rotate_by<double>(turn(end), Point3D(1, 0, 0))), "R v");
  }
  p.dot("dot", {4, 0}, "v");
}

void s43_whole_sphere(Plane &p) { draw_hull_in_cap(p, {{1, 0}, {1, 0}, {1, 0}, {-7. / 25, 24. / 25}}); }

void s44_sum(Plane &p) {
  std::vector<Ball3<double>> balls;
  for (const Point &r : weight_vertex_images_of_box()) balls.push_back({{r[0], r[1], 0}, 0.5});
  draw_balls_and_theirs(p, balls);
}
void s44_joint_sets(Plane &p) {
  std::vector<Ball3<double>> balls;
  for (const Point &r : weight_vertex_images_of_box()) balls.push_back({{r[0], r[1], 0}, 0.25});
  for (const Point &r : {Point(2.4, -0.3), Point(2.2, 0.4)}) balls.push_back({{r[0], r[1], 0}, 0.45});
  draw_balls_and_theirs(p, balls);
}

}  // namespace

const std::vector<Drawing> &drawings_of_sections() {
  static const std::vector<Drawing> all{
      {"s41_weight_vertices_span", s41,
       "The weights of three joints as points of a triangle: what the bounds "
       "admit (filled), and its weight vertices."},
      {"s42_linear_part_hull", s42,
       "Where three joints carry the rotation center (C r), and where the "
       "weight vertices do (r'): the hull of these "
       "holds what admissible weights can reach."},
      {"s43_distance_range", s43_distance_range,
       "A ball that meets the circle has a distance in [0, 1]. The dashed one "
       "passes the printed conditions and has "
       "13/8."},
      {"s43_minkowski_sum", s43_minkowski_sum, "A ball turned about r by blends: its center moves, its size does not."},
      {"s43_rotated_cap", s43_rotated_cap,
       "Left, a cap of rotations up to the angle 40° about 1 (the half angle "
       "of the turn). Right, what they make of v: "
       "up to twice that."},
      {"s43_whole_sphere_fallback", s43_whole_sphere,
       "Three equal quaternions and one at (−7/25, 24/25): the mean ball has "
       "the radius 6/5, and its cap (yellow) is "
       "good."},
      {"s44_joint_sets", s44_joint_sets,
       "The balls of two joint-sets, each about images of its own weight vertices, and "
       "the ball (dashed) around all of them."},
      {"s44_sum_of_bounds", s44_sum,
       "Equal balls about the images of the weight vertices, and the smallest ball "
       "(dashed) around them."}};
  return all;
}

}  // namespace refitlab::drawings
