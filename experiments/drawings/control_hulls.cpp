// SPDX-License-Identifier: GPL-3.0-or-later
// These are the drawings of the lemmas beyond the paper.
#include "experiments/drawings/common.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b2_control_hull_encloses.hpp"
#include "lemmas/b3_subdivision.hpp"
#include "lemmas/b4_cap_fallback.hpp"
#include "lemmas/b5_rotation_axis.hpp"
#include "lemmas/b6_dual_quaternion_ball.hpp"
#include "lemmas/b7_motion_bound.hpp"
#include "lemmas/b8_blend_error.hpp"
#include "lemmas/b9_pose_change.hpp"
#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/t3_one_cap.hpp"

namespace refitlab::drawings {
namespace {

// Returns a blend of two weight vertices that turn apart and are carried apart.
SphericalBlend<double> bend() { return {{turn(0), turn(140)}, {{0, 0, 0}, {0.4, 0.3, 0}}, {1.2, 0.3, 0}}; }
template <class Blend>
std::vector<Point> curve_of(const Blend &blend) {
  std::vector<Point> out;
  for (int i = 0; i <= 60; ++i) {
    const double u[] = {1 - i / 60., i / 60.};
    const auto at = blend.at(std::span<const double>(u));
    out.push_back(flat(Point3D(at.numerator / at.denominator)));
  }
  return out;
}
template <class Blend>
std::vector<Point> control_polygon(const Blend &blend) {
  std::vector<Point> out;
  for (const auto &c : positions(control_points(blend))) out.push_back(flat(c));
  return out;
}
void draw_blend(Plane &p, const SphericalBlend<double> &blend) {
  p.path("hull", control_polygon(blend), true);
  p.path("curve", curve_of(blend));
  for (const Point &c : control_polygon(blend)) p.dot("dot_in", c);
}
void b1(Plane &p) { draw_blend(p, bend()); }
void b2(Plane &p) {
  std::vector<Ball3<double>> balls;
  for (const auto &c : positions(control_points(bend()))) balls.push_back({c, 0.3});
  draw_balls_and_theirs(p, balls);
  p.path("curve", curve_of(bend()));
}
void b3(Plane &p) {
  p.path("line", control_polygon(bend()), true);
  for (const Half &half : {Half{0, 1}, Half{1, 0}}) draw_blend(p, half_of(bend(), half));
}

CapFallback<double> wide_cap() {
  const Quat axis = turn(70);
  const std::vector<Quat> rotations{turn(0), turn(140)};
  return {rotations, {{0, 0, 0}, {0.4, 0.3, 0}}, axis, squared_cap_cosine<double>(rotations, axis)};
}
void b4(Plane &p) {
  const auto cap = wide_cap();
  const auto ball = fallback_ball(cap, bend().x);
  for (const auto &r : cap.center_images)
    p.ball("ball", {flat(Point3D(r + ball.center)), ball.squared_radius}), p.dot("dot", flat(r), "r'");
  p.path("curve", curve_of(bend()));
}

// This is seen from the side. The axis stands upright, and a turning point keeps its height.
void b5(Plane &p) {
  const CapFallback<double> cap{{turn(0), turn(80)},
                                {{0, 0, 0}, {0, 0, 0}},
                                turn(40),
                                squared_cap_cosine<double>(std::vector<Quat>{turn(0), turn(80)}, turn(40))};
  const Point3D x(0.5, 0, 1.5);
  const auto side = [](const Point3D &v) { return Point(v[0], v[2]); };
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
void b6(Plane &p) {
  const auto blend = dual_blend<double>(two_joints(), {1.2, 0.3, 0});
  const auto curve = curve_of(blend);
  const Point middle = mean_center(std::span<const Point>(curve));
  p.ball("ball", flat(dual_quaternion_ball<double>(blend, turn(40), {middle[0], middle[1], 0})));
  p.path("curve", curve);
  p.dot("dot_in", middle, "center");
}
void b7(Plane &p) {
  const Point3D point(1.2, 0.3, 0);
  const auto joints = two_joints();
  const auto images = images_of<double>(joints, point);
  const double cosine = dot(joints[0].rotation, joints[1].rotation);
  const double length = std::sqrt(squared_deviation_share(cosine) * squared_spread(images));
  for (const auto &c : images) p.circle("ball", flat(c), length), p.dot("dot", flat(c), "C f");
  p.path("line", {flat(images[0]), flat(images[1])});
  p.path("curve", curve_of(dual_blend(joints, point)));
}
// All quaternions of the plane that are this far from 1.
void b8(Plane &p) {
  const Point3D x(1.2, 0.3, 0);
  const double error = 0.25;
  p.circle("ball", flat(x), turn_of_error(error, 1.) * norm<double, 3>(x));
  std::vector<Point> images;
  for (int i = 0; i <= 60; ++i) {
    const double angle = i * std::acos(-1.) / 30;
    images.push_back(flat(rotate_by<double>(Quat(1 + error * std::cos(angle), 0, 0, error * std::sin(angle)), x)));
  }
  p.path("curve", images);
  p.dot("dot", {0, 0}, "axis"), p.dot("dot_in", flat(x), "R x");
}
// Two joints turn a little against one another, and go on a little.
void b9(Plane &p) {
  const Point3D point(1.2, 0.3, 0);
  const auto old = two_joints();
  const std::vector<RigidTransform<double>> now{{turn(-6), {0.05, 0.1, 0}}, {turn(86), {0.45, 0.45, 0}}};
  const auto before = images_of<double>(old, point), after = images_of<double>(now, point);
  PoseChangeBounds<double> bounds{dot(old[0].rotation, old[1].rotation), 0, 0, std::sqrt(squared_spread(before))};
  for (std::size_t k = 0; k < old.size(); ++k) {
    bounds.turn = std::max(bounds.turn, norm<double, 4>(now[k].rotation - old[k].rotation));
    bounds.moved = std::max(bounds.moved, norm<double, 3>(after[k] - before[k]));
  }
  const double share = std::sqrt(squared_deviation_share(bounds.cosine_after()));
  const double length = growth_by_change(bounds.moved, share, bounds.spread_after(old.size()));
  // The images are close to each other, so each pose has its name at one of them.
  for (const auto &c : before) p.circle("ball", flat(c), length);
  p.dot("dot", flat(before[0])), p.dot("dot", flat(before[1]), "C f");
  p.dot("dot_in", flat(after[0]), "C' f"), p.dot("dot_in", flat(after[1]));
  p.path("line", {flat(before[0]), flat(before[1])});
  p.path("curve", curve_of(dual_blend(now, point)));
}

}  // namespace

const std::vector<Drawing> &drawings_of_control_hulls() {
  static const std::vector<Drawing> all{{"b1_rational_bezier_simplex", b1,
                                         "A vertex between two joints that turn apart by 140 degrees: its way as "
                                         "the weight changes, and the four control "
                                         "points of degree 3."},
                                        {"b2_control_hull_encloses", b2,
                                         "Balls about the control points, and the smallest ball (dashed) around "
                                         "them: it holds every vertex that is as "
                                         "near to the curve."},
                                        {"b3_subdivision", b3,
                                         "The weights halved: two control polygons that are together far closer "
                                         "to the curve than the one."},
                                        {"b4_cap_fallback", b4,
                                         "Where control weights are not positive: a ball about each weight vertex’s "
                                         "image, of the cap that holds all "
                                         "rotations."},
                                        {"b5_rotation_axis", b5,
                                         "From the side: a twist moves x about the axis alone. The ball of the "
                                         "cap (dashed) does not know the axis; the "
                                         "small one does."},
                                        {"b6_dual_quaternion_ball", b6,
                                         "The way of a vertex under dual quaternions, and the ball about its "
                                         "middle, from the two joints alone."},
                                        {"b7_motion_bound", b7,
                                         "From the images of a point by two joints alone: the hull of these "
                                         "balls holds the way of the dual quaternion "
                                         "blend."},
                                        {"b8_blend_error", b8,
                                         "The images of a point by all quaternions in a plane that are off by a quarter "
                                         "of their length, and the ball that "
                                         "holds them."},
                                        {"b9_pose_change", b9,
                                         "The images of a point in one pose, and its way in another pose, by dual quaternions: "
                                         "the hull of these balls holds it, made of the old images and of how far the joints "
                                         "are from where they were."}};
  return all;
}

}  // namespace refitlab::drawings
