// reference_pictures: a picture for each lemma, of what the lemma's own code computes in double.   usage:
// reference_pictures FOLDER
//
// Lemmas of R^d are drawn for d = 2. Those of rotations have all joints turn about z: points stay in the plane, and a
// quaternion is its (w, z).
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>

#include "algorithms/balls/few_balls_ball.hpp"
#include "algorithms/balls/mean_ball.hpp"
#include "algorithms/balls/smallest_ball.hpp"
#include "algorithms/weights/corners.hpp"
#include "experiments/reference/plane.hpp"
#include "lemmas/b3_subdivision.hpp"
#include "lemmas/b5_rotation_axis.hpp"
#include "lemmas/b7_reach.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/s43_whole_sphere_fallback.hpp"
#include "lemmas/t3_smallest_ball_smallest_cap.hpp"

namespace {

using namespace refitlab;
using reference::Plane;
using reference::Point;
using Quat = Quaternion<double>;
using Point3D = Vec<double, 3>;

const SquaredBall<double, 2> unit_circle{{0, 0}, 1};
Point flat(const Point3D& p) { return {p[0], p[1]}; }
SquaredBall<double, 2> flat(const SquaredBall<double, 3>& b) { return {flat(b.center), b.squared_radius}; }
SquaredBall<double, 2> flat(const Ball3<double>& b) { return {flat(b.center), sq(b.radius)}; }
Point on_circle(double degrees) { return Plane::turned({1, 0}, degrees * std::numbers::pi / 180); }
// The rotation by this angle about z.
Quat turn(double degrees) {
  const Point half = on_circle(degrees / 2);
  return {half[0], 0, 0, half[1]};
}
Point slice(const Quat& q) { return {q[0], q[3]}; }

SquaredBall<double, 2> mean_ball_of(const std::vector<Point>& points) {
  return squared(mean_ball<double, 2>(std::span<const Point>(points)));
}

void draw_surface_and_cap(Plane& plane, const SquaredBall<double, 2>& ball) {
  plane.circle("surface", {0, 0}, 1);
  const auto h = intersection_cap(unit_circle, ball).half_space;
  const auto made = cap_of_half_space_by_root(unit_circle, h);
  if (made.verdict == Verdict::holds) plane.cap(made.cap);
  plane.border(h);
}

void lemma1(Plane& p) {
  const HalfSpace<double, 2> h{{1.2, 0.5}, 0.6};
  p.circle("surface", {0, 0}, 1);
  const auto made = cap_of_half_space_by_root(unit_circle, h);
  p.cap(made.cap);
  p.border(h);
  p.path("line", {{0, 0}, made.cap.apex});
  p.dot("dot", {0, 0}, "c"), p.dot("dot_in", made.cap.apex, "a");
}

void lemma2(Plane& p) {
  const VecList<double, 2> q{on_circle(-20) * 1.6, on_circle(35) * 0.7, on_circle(110) * 1.3};
  const auto lengths = lengths_by_roots<double, 2>(q);
  const auto n = divided<double, 2>(q, lengths);
  const std::vector<double> w{0.3, 0.3, 0.4};
  const auto partner = weights_on_same_ray(w, lengths);
  const Point a = combine<double, 2>(w, q), b = combine<double, 2>(partner.weights, n);
  p.circle("surface", {0, 0}, 1);
  p.path("hull", q, true), p.path("line", n, true);
  p.path("curve", {{0, 0}, a[0] * a[0] + a[1] * a[1] > b.squaredNorm() ? a : b});
  for (int i = 0; i < 3; ++i) p.dot("dot", q[i], "q" + std::to_string(i + 1)), p.dot("dot_in", n[i]);
  p.dot("dot", {0, 0}, "0"), p.dot("dot", a, "a"), p.dot("dot_in", b, "b");
}

void lemma3(Plane& p) {
  const SquaredBall<double, 2> ball{on_circle(25) * 1.1, 0.36};
  draw_surface_and_cap(p, ball);
  p.ball("ball", ball);
  const auto foot = nearest_point_of_intersection_cap(unit_circle, ball).foot;
  p.path("line", {{0, 0}, foot});
  p.dot("dot", {0, 0}, "0"), p.dot("dot", ball.center, "b"), p.dot("dot_in", foot, "d_H");
}

void draw_hull_in_cap(Plane& p, const std::vector<Point>& units) {
  const auto ball = mean_ball_of(units);
  draw_surface_and_cap(p, ball);
  p.ball("ball", ball);
  p.path("hull", units, true);
  std::vector<double> w(units.size(), 0.2 / static_cast<double>(units.size() - 2));
  w.front() = 0.45, w.back() = 0.35;
  const auto element = hull_element(ball, units, w);
  p.path("curve", {{0, 0}, direction_by_root(element.blend)});
  for (const Point& n : units) p.dot("dot", n);
  p.dot("dot_in", element.blend, "b"), p.dot("dot_in", direction_by_root(element.blend)),
      p.dot("dot", ball.center, "c");
}
void lemma4(Plane& p) { draw_hull_in_cap(p, {on_circle(-35), on_circle(20), on_circle(70)}); }

void lemma5(Plane& p) {
  const Cap<double, 2> cap{{0, 0}, on_circle(20), -0.6};
  p.circle("surface", {0, 0}, 1);
  p.ball("ball", cap_ball_repaired(cap));
  p.ball("printed", cap_ball_printed(cap));
  p.cap(cap);
  p.dot("dot_out", cap.apex, "apex"), p.dot("dot", cap_ball_printed(cap).center, "printed"),
      p.dot("dot_in", {0, 0}, "repaired");
}

// The weights of three joints as a triangle.
Point in_triangle(const std::vector<double>& w) {
  return on_circle(90) * w[2] + on_circle(210) * w[0] + on_circle(330) * w[1];
}
const WeightBounds<double> box{{0.1, 0.15, 0.05}, {0.6, 0.5, 0.55}};
std::vector<Point> around_their_middle(std::vector<Point> points) {
  const Point middle = mean_center(std::span<const Point>(points));
  std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return std::atan2(a[1] - middle[1], a[0] - middle[0]) < std::atan2(b[1] - middle[1], b[0] - middle[0]);
  });
  return points;
}
void s41(Plane& p) {
  p.path("line", {in_triangle({1, 0, 0}), in_triangle({0, 1, 0}), in_triangle({0, 0, 1})}, true);
  std::vector<Point> corners;
  for (const auto& c : corners_or_simplex(box)) corners.push_back(in_triangle(c));
  p.path("hull", around_their_middle(corners), true);
  for (const Point& c : corners) p.dot("dot_in", c);
  p.text(in_triangle({1, 0, 0}), "w1 = 1"), p.text(in_triangle({0, 1, 0}), "w2 = 1"),
      p.text(in_triangle({0, 0, 1}), "w3 = 1");
}

std::vector<Point> deformed_centers() { return {{0, 0}, {1.6, 0.2}, {0.7, 1.3}}; }
std::vector<Point> corner_images_of_box() {
  return corner_images<double, 2>(corners_or_simplex(box), deformed_centers());
}
void s42(Plane& p) {
  p.path("line", deformed_centers(), true);
  p.path("hull", around_their_middle(corner_images_of_box()), true);
  for (const Point& r : deformed_centers()) p.dot("dot", r, "C r");
  for (const Point& r : corner_images_of_box()) p.dot("dot_in", r, "r'");
}

void s43_distance_range(Plane& p) {
  p.circle("surface", {0, 0}, 1);
  const Ball<double, 2> good{on_circle(20), 0.6}, bad{{3, 0}, 0.5};
  p.ball("ball", squared(good)), p.ball("printed", squared(bad));
  p.dot("dot_in", good.center, std::string("in range: ") + name_of(distance_range_repaired(good.center, good.radius)));
  p.dot("dot_out", bad.center, std::string("printed: ") + name_of(distance_range_printed(bad.center, bad.radius)));
}

void s43_minkowski_sum(Plane& p) {
  const Point3D center(1.2, 0, 0);
  std::vector<Point> path;
  for (int i = 0; i <= 20; ++i)
    path.push_back(flat(rotate_by<double>(turn(0) * (1 - i / 20.) + turn(120) * (i / 20.), center)));
  for (int i = 0; i <= 20; i += 5) p.circle("ball", path[i], 0.35);
  p.path("curve", path);
  p.dot("dot", {0, 0}, "r_c"), p.dot("dot", path[0], "p");
}

void s43_rotated_cap(Plane& p) {
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

void s43_whole_sphere(Plane& p) { draw_hull_in_cap(p, {{1, 0}, {1, 0}, {1, 0}, {-7. / 25, 24. / 25}}); }

void draw_balls_and_theirs(Plane& p, const std::vector<Ball3<double>>& balls) {
  for (const auto& b : balls) p.ball("ball", flat(b)), p.dot("dot", flat(b.center));
  p.ball("outer", flat(few_balls_enclosing(balls)));
}
void s44_sum(Plane& p) {
  std::vector<Ball3<double>> balls;
  for (const Point& r : corner_images_of_box()) balls.push_back({{r[0], r[1], 0}, 0.5});
  draw_balls_and_theirs(p, balls);
}
void s44_joint_sets(Plane& p) {
  std::vector<Ball3<double>> balls;
  for (const Point& r : corner_images_of_box()) balls.push_back({{r[0], r[1], 0}, 0.25});
  for (const Point& r : {Point(2.4, -0.3), Point(2.2, 0.4)}) balls.push_back({{r[0], r[1], 0}, 0.45});
  draw_balls_and_theirs(p, balls);
}

void t3_min_dot(Plane& p) {
  const std::vector<Point> units{on_circle(-50), on_circle(10), on_circle(65)};
  const auto ball = mean_ball_of(units);
  const auto least = min_dot_distance<double, 2>(units, ball.center, ball.squared_radius);
  draw_surface_and_cap(p, ball);
  const Point axis = ball.center.normalized();
  for (const Point& n : units) p.path("line", {n, axis * n.dot(axis)}), p.dot("dot", n);
  p.dot("dot_in", units[least.nearest], "the least"), p.dot("dot", ball.center, "c");
}

void t3_one_cap(Plane& p) {
  const std::vector<Quat> list{turn(-60) * 1.5, turn(20) * 0.6, turn(90) * 1.2};
  const Quat axis = turn(20);
  p.circle("surface", {0, 0}, 1);
  p.cap({{0, 0}, slice(axis), std::sqrt(squared_cap_cosine<double>(list, axis))});
  std::vector<Point> hull;
  for (const Quat& q : list) hull.push_back(slice(q)), p.path("line", {{0, 0}, slice(q)});
  p.path("hull", hull, true);
  for (const Point& q : hull) p.dot("dot", q, "q'");
  p.dot("dot_in", slice(axis), "c");
}

void t3_smallest(Plane& p) {
  const std::vector<Point> units{on_circle(-10), on_circle(0), on_circle(8), on_circle(100)};
  const auto ball = smallest_ball<double, 2>(units);
  p.ball("outer", mean_ball_of(units));
  const SquaredBall<double, 2> smallest{ball.center, ball.squared_radius};
  draw_surface_and_cap(p, smallest);
  p.ball("ball", smallest);
  p.path("line", {{0, 0}, ball.center});
  for (const Point& n : units) p.dot("dot", n);
  p.dot("dot_in", ball.center, "smallest");
}

// Two corners that turn apart and are carried apart.
SphericalBlend<double> bend() { return {{turn(0), turn(140)}, {{0, 0, 0}, {0.4, 0.3, 0}}, {1.2, 0.3, 0}}; }
template <class Blend>
std::vector<Point> curve_of(const Blend& blend) {
  std::vector<Point> out;
  for (int i = 0; i <= 60; ++i) {
    const double u[] = {1 - i / 60., i / 60.};
    const auto at = blend.at(std::span<const double>(u));
    out.push_back(flat(Point3D(at.numerator / at.denominator)));
  }
  return out;
}
template <class Blend>
std::vector<Point> control_polygon(const Blend& blend) {
  std::vector<Point> out;
  for (const auto& c : positions(control_points(blend))) out.push_back(flat(c));
  return out;
}
void draw_blend(Plane& p, const SphericalBlend<double>& blend) {
  p.path("hull", control_polygon(blend), true);
  p.path("curve", curve_of(blend));
  for (const Point& c : control_polygon(blend)) p.dot("dot_in", c);
}
void b1(Plane& p) { draw_blend(p, bend()); }
void b2(Plane& p) {
  std::vector<Ball3<double>> balls;
  for (const auto& c : positions(control_points(bend()))) balls.push_back({c, 0.3});
  draw_balls_and_theirs(p, balls);
  p.path("curve", curve_of(bend()));
}
void b3(Plane& p) {
  p.path("line", control_polygon(bend()), true);
  for (const Half& half : {Half{0, 1}, Half{1, 0}}) draw_blend(p, half_of(bend(), half));
}

CapFallback<double> wide_cap() {
  const Quat axis = turn(70);
  const std::vector<Quat> rotations{turn(0), turn(140)};
  return {rotations, {{0, 0, 0}, {0.4, 0.3, 0}}, axis, squared_cap_cosine<double>(rotations, axis)};
}
void b4(Plane& p) {
  const auto cap = wide_cap();
  const auto ball = fallback_ball(cap, bend().x);
  for (const auto& r : cap.center_images)
    p.ball("ball", {flat(Point3D(r + ball.center)), ball.squared_radius}), p.dot("dot", flat(r), "r'");
  p.path("curve", curve_of(bend()));
}

// Seen from the side: the axis stands upright, and what turns keeps its height.
void b5(Plane& p) {
  const CapFallback<double> cap{{turn(0), turn(80)},
                                {{0, 0, 0}, {0, 0, 0}},
                                turn(40),
                                squared_cap_cosine<double>(std::vector<Quat>{turn(0), turn(80)}, turn(40))};
  const Point3D x(0.5, 0, 1.5);
  const auto side = [](const Point3D& v) { return Point(v[0], v[2]); };
  const auto whole = fallback_ball(cap, x), twist = twist_ball(cap, split_at_axis<double>({0, 0, 1}, x));
  p.ball("outer", {side(whole.center), whole.squared_radius});
  p.ball("ball", {side(twist.center), twist.squared_radius});
  p.path("plane", {{0, -0.2}, {0, 2}});
  std::vector<Point> path;
  for (int i = 0; i <= 20; ++i) path.push_back(side(rotate_by<double>(turn(80. * i / 20), x)));
  p.path("curve", path);
  p.dot("dot", {0, 0}, "axis"), p.dot("dot_in", side(x), "x");
}

std::vector<RigidTransform<double>> two_joints() { return {{turn(0), {0, 0, 0}}, {turn(80), {0.5, 0.4, 0}}}; }
void b6(Plane& p) {
  const auto blend = dual_blend<double>(two_joints(), {1.2, 0.3, 0});
  const auto curve = curve_of(blend);
  const Point middle = mean_center(std::span<const Point>(curve));
  p.ball("ball", flat(dual_quaternion_ball<double>(blend, turn(40), {middle[0], middle[1], 0})));
  p.path("curve", curve);
  p.dot("dot_in", middle, "center");
}
void b7(Plane& p) {
  const Point3D point(1.2, 0.3, 0);
  const auto joints = two_joints();
  const auto images = images_of(joints, point);
  const double length = 0.75 * std::sqrt((1 - dot(joints[0].rotation, joints[1].rotation)) * squared_spread(images));
  for (const auto& c : images) p.circle("ball", flat(c), length), p.dot("dot", flat(c), "C f");
  p.path("line", {flat(images[0]), flat(images[1])});
  p.path("curve", curve_of(dual_blend(joints, point)));
}

struct Picture {
  void (*draw)(Plane&);
  const char* caption;
};
const std::map<std::string, Picture> pictures{
    {"b1_rational_bezier_simplex",
     {b1,
      "A vertex between two joints that turn apart by 140 degrees: its way as the weight changes, and the four control "
      "points of degree 3."}},
    {"b2_control_hull_encloses",
     {b2,
      "Balls about the control points, and the smallest ball (dashed) around them: it holds every vertex that is as "
      "near to the curve."}},
    {"b3_subdivision",
     {b3, "The weights halved: two control polygons that are together far closer to the curve than the one."}},
    {"b4_cap_fallback",
     {b4,
      "Where control weights are not positive: a ball about each corner’s image, of the cap that holds all "
      "rotations."}},
    {"b5_rotation_axis",
     {b5,
      "From the side: a twist moves x about the axis alone. The ball of the cap (dashed) does not know the axis; the "
      "small one does."}},
    {"b6_dual_quaternion_ball",
     {b6, "The way of a vertex under dual quaternions, and the ball about its middle, from the two joints alone."}},
    {"b7_reach",
     {b7,
      "From the images of a point by two joints alone: the hull of these balls holds the way of the dual quaternion "
      "blend."}},
    {"lemma1_cap_definitions",
     {lemma1, "The half-space (its border green) cuts the cap (yellow) with apex a from the circle about c."}},
    {"lemma2_normalization",
     {lemma2,
      "The hull of the q (filled) and that of the same vectors at length 1: the blend a and its partner b are on one "
      "ray from 0."}},
    {"lemma3_sphere_surface_intersection",
     {lemma3, "The ball about b cuts the cap (yellow) from the circle; its half-space is at the distance d from 0."}},
    {"lemma4_quaternion_hull",
     {lemma4,
      "Three unit vectors, their mean ball about c and its cap (yellow): the blend b, brought back to the circle, is "
      "in the cap."}},
    {"lemma5_cap_enclosing_sphere",
     {lemma5,
      "A cap (yellow) with cos α = −0.6: its apex is outside the printed ball (dashed); the repaired one is the whole "
      "circle’s."}},
    {"s41_corners_span",
     {s41, "The weights of three joints as points of a triangle: what the bounds admit (filled), and its corners."}},
    {"s42_linear_part_hull",
     {s42,
      "Where three joints carry the rotation center (C r), and where the corners of the weights do (r'): the hull of "
      "these holds what admissible weights can reach."}},
    {"s43_distance_range",
     {s43_distance_range,
      "A ball that meets the circle has a distance in [0, 1]. The dashed one passes the printed conditions and has "
      "13/8."}},
    {"s43_minkowski_sum", {s43_minkowski_sum, "A ball turned about r by blends: its center moves, its size does not."}},
    {"s43_rotated_cap",
     {s43_rotated_cap,
      "Left, a cap of rotations up to the angle 40° about 1 (the half angle of the turn). Right, what they make of v: "
      "up to twice that."}},
    {"s43_whole_sphere_fallback",
     {s43_whole_sphere,
      "Three equal quaternions and one at (−7/25, 24/25): the mean ball has the radius 6/5, and its cap (yellow) is "
      "good."}},
    {"s44_joint_sets",
     {s44_joint_sets,
      "The balls of two joint-sets, each about images of its own corners, and the ball (dashed) around all of them."}},
    {"s44_sum_of_bounds",
     {s44_sum, "Equal balls about the images of the corners, and the smallest ball (dashed) around them."}},
    {"t3_min_dot_distance",
     {t3_min_dot,
      "The cap’s half-space is as far from 0 as the least of the dot products with the center’s direction."}},
    {"t3_one_cap",
     {t3_one_cap,
      "Quaternions of different lengths, not normalised: the cap about c (yellow) holds the directions of their whole "
      "hull."}},
    {"t3_smallest_ball_smallest_cap",
     {t3_smallest,
      "The smallest ball of the units makes the smallest cap (yellow). Three that are close drag the mean ball "
      "(dashed) along."}}};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::invalid_argument("usage: reference_pictures FOLDER");
  std::filesystem::create_directories(argv[1]);
  for (const auto& [stem, picture] : pictures) {
    Plane plane;
    picture.draw(plane);
    const std::string path = (std::filesystem::path(argv[1]) / (stem + ".svg")).string();
    std::ofstream file(path);
    if (!(file << plane.svg(picture.caption))) throw std::runtime_error(path + ": cannot be written");
  }
} catch (const std::exception& e) {
  std::cerr << "reference_pictures: " << e.what() << '\n';
  return 1;
}
