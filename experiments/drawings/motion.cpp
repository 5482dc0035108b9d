// SPDX-License-Identifier: GPL-3.0-or-later
// These are the drawings of bounds over time, of affine joints and of displaced vertices.
#include "experiments/drawings/common.hpp"
#include "lemmas/a1_affine_image.hpp"
#include "lemmas/a2_two_phase_skinning.hpp"
#include "lemmas/a3_morph_displacement.hpp"
#include "lemmas/a4_joint_volumes.hpp"
#include "lemmas/b7_motion_bound.hpp"
#include "lemmas/c1_chord_bound.hpp"
#include "lemmas/c2_channel_motion.hpp"
#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/c4_chain_motion.hpp"
#include "lemmas/c5_skinned_motion.hpp"
#include "lemmas/c6_interval_hull.hpp"
#include "lemmas/c7_crossfade.hpp"
#include "lemmas/c8_any_pose.hpp"

namespace refitlab::drawings {
namespace {

constexpr int steps = 60;

// Draws a curve over [0, 1], its chord, and how far from the chord the bound lets the curve deviate.
template <class Curve>
void draw_near_chord(Plane &p, const Curve &at, double slack) {
  std::vector<Point> curve;
  for (int i = 0; i <= steps; ++i) curve.push_back(at(i / double(steps)));
  p.path("line", {curve.front(), curve.back()});
  for (int i = 0; i <= 4; ++i) p.circle("ball", between<double, 2>(curve.front(), curve.back(), i / 4.), slack);
  p.path("curve", curve);
  p.dot("dot", curve.front()), p.dot("dot", curve.back());
}

void rectangle(Plane &p, const std::string &kind, const Slab<double> &x, const Slab<double> &y) {
  p.path(kind, {{x.low, y.low}, {x.high, y.low}, {x.high, y.high}, {x.low, y.high}}, true);
}

void c1(Plane &p) {
  const CubicCurve<double, 2> curve{{Point(0, 0), Point(0.4, 0.9), Point(1.2, 0.9), Point(2, 0.2)}, 1};
  const auto bends = curve.accelerations();
  draw_near_chord(
      p, [&](double s) { return curve.at(s); }, chord_slack(std::max(norm(bends[0]), norm(bends[1])), 1.));
}

void c2(Plane &p) {
  const auto curve = spline_curve<double, 2>({0, 0}, {1, 3}, {1, -3}, {2, 0.5}, 1.);
  std::vector<Point> path;
  for (int i = 0; i <= steps; ++i) path.push_back(curve.at(i / double(steps)));
  p.path("hull", {curve.points.begin(), curve.points.end()}, true);
  p.path("curve", path);
  for (const Point &point : curve.points) p.dot("dot", point);
}

void c3(Plane &p) {
  const Point first = on_circle(-55), second = on_circle(55);
  p.circle("surface", {0, 0}, 1), p.circle("ball", {0, 0}, least_half_way(first.dot(second)));
  p.path("line", {first, second});
  for (int i = 0; i <= 8; ++i) {
    const Point blend = between<double, 2>(first, second, i / 8.);
    p.path("line", {{0, 0}, blend.normalized()}), p.dot("dot", blend), p.dot("dot_in", blend.normalized());
  }
}

// The arm has two hinges with bones of the length 1, and moves over a second.
const double outer_turn = 50, inner_turn = 35;
std::vector<RigidTransform<double>> arm_at(double time) {
  const RigidTransform<double> shoulder{turn(outer_turn * time - 20), {0, 0, 0}}, elbow{turn(inner_turn * time), {1, 0, 0}};
  return {shoulder, compose(shoulder, elbow)};
}
LinkMotion<double> hinge(double degrees, double bone) {
  return {at_rest(bone), circle_motion(degrees / 2 * std::numbers::pi / 180), at_rest(1.)};
}
ChainMotion<double> arm_motion() { return compose(chain_of(hinge(outer_turn, 0)), chain_of(hinge(inner_turn, 1))); }

void c4(Plane &p) {
  for (int i = 0; i <= 2; ++i) {
    const auto joints = arm_at(i / 2.);
    p.path("line", {{0, 0}, flat(joints[1].translation), flat(apply(joints[1], Point3D(1, 0, 0)))});
  }
  draw_near_chord(
      p, [](double t) { return flat(apply(arm_at(t)[1], Point3D(1, 0, 0))); },
      chord_slack(carried_motion(arm_motion(), at_rest(1.)), 1.));
}

void c5(Plane &p) {
  const Point3D vertex(1.2, 0.1, 0);
  const auto outer = chain_of(hinge(outer_turn, 0));
  // The images are in the frame of the outer joint. The vertex hangs between both joints, 0.2 from the elbow.
  const std::vector<Motion<double>> images{at_rest(0.3), carried_motion(chain_of(hinge(inner_turn, 0)), at_rest(0.3))},
      rotations{at_rest(1.), circle_motion(inner_turn / 2 * std::numbers::pi / 180)};
  const double least = std::sqrt(least_squared_blend(std::cos(inner_turn / 2 * std::numbers::pi / 180), 2.));
  const std::vector<double> halves{0.5, 0.5};
  const auto skinned = [&](double time) {
    auto joints = arm_at(time);
    joints[1] = compose(joints[1], {turn(0), {-1, 0, 0}});
    const auto at = dual_blend(joints, vertex).at(halves);
    return flat(Point3D(at.numerator / at.denominator));
  };
  draw_near_chord(p, skinned,
                  chord_slack(product(outer.linear, dual_motion<double>(images, rotations, least) + at_rest(1.)), 1.));
  p.dot("dot_in", {0, 0}, "joint");
}

void c6(Plane &p) {
  const auto slab = [](double low, double high) { return Slab<double>{low, high}; };
  const double slack = chord_slack(circle_motion(1.3), 1.);
  std::vector<Point> arc;
  for (int i = 0; i <= steps; ++i) arc.push_back(Plane::turned({1, 0}, 1.3 * (i / double(steps) - 0.5)));
  const auto x = slab(arc.front()[0], arc.front()[0]), y = slab(arc.front()[1], arc.front()[1]),
             end = slab(arc.back()[1], arc.back()[1]);
  rectangle(p, "ball", interval_slab(x, x, slack, 1.), interval_slab(y, end, slack, 1.));
  p.path("line", {arc.front(), arc.back()}), p.path("curve", arc);
  p.dot("dot", arc.front(), "key"), p.dot("dot", arc.back(), "key");
}

void c7(Plane &p) {
  const Quat first = turn(-60), second = turn(60);
  const double cosine = dot(first, second);
  std::vector<Point> path;
  for (int i = 0; i <= steps; ++i)
    path.push_back(flat(rotate<double>(between<double, 4>(first, second, i / double(steps)).normalized(), Point3D(1, 0, 0))));
  const auto motion = carried_motion(
      chain_of<double>({at_rest(0.), nlerp_motion(faded_by_weight(1., 1., gap_of_units(cosine)), cosine), at_rest(1.)}),
      at_rest(1.));
  draw_near_chord(
      p, [&](double w) { return path[static_cast<std::size_t>(std::lround(w * steps))]; }, chord_slack(motion, 1.));
  p.path("line", {{0, 0}, path.front()}), p.path("line", {{0, 0}, path.back()});
}

void c8(Plane &p) {
  const std::vector<LinkRange<double>> links{{0, 1}, {1, 1}};
  p.circle("ball", {0, 0}, reach_of_chain<double>(links, 0.8));
  for (const double bend : {0., 70., 140.}) {
    const Point elbow = on_circle(20 + bend / 3), hand = elbow + on_circle(20 + bend / 3 + bend) * 0.8;
    p.path("line", {{0, 0}, elbow, hand}), p.dot("dot", elbow), p.dot("dot_in", hand);
  }
}

void a1(Plane &p) {
  const AffineMap<double> map{{Point3D(1.4, 0.3, 0), Point3D(0.5, 0.8, 0), Point3D(0, 0, 1)}, {2.2, 0, 0}};
  const SquaredBall<double, 3> ball{{0, 0, 0}, 0.6};
  std::vector<Point> image;
  for (int i = 0; i <= steps; ++i) {
    const Point on = on_circle(360. * i / steps) * std::sqrt(ball.squared_radius);
    image.push_back(flat(apply(map, Point3D(on[0], on[1], 0))));
  }
  p.ball("ball", flat(ball)), p.ball("outer", flat(image_of_ball(map, ball)));
  p.path("curve", image, true);
}

void a2(Plane &p) {
  const std::vector<AffineMap<double>> scales{{{Point3D(1, 0, 0), Point3D(0, 1, 0), Point3D(0, 0, 1)}, {0, 0, 0}},
                                              {{Point3D(2, 0, 0), Point3D(0, 0.6, 0), Point3D(0, 0, 1)}, {0, 0, 0}}};
  const SquaredBall<double, 3> reference{{1, 0.4, 0}, 0.09};
  for (const auto &ball : scaled_balls<double>(scales, reference)) p.ball("ball", flat(ball)), p.dot("dot", flat(ball.center));
  std::vector<Point> blends;
  for (int i = 0; i <= 8; ++i)
    blends.push_back(flat(linear_blend<double>(scales, std::vector<double>{1 - i / 8., i / 8.}, Point3D(1.2, 0.6, 0))));
  p.path("curve", blends);
}

void a3(Plane &p) {
  const Ball3<double> reference{{0, 0, 0}, 0.5};
  const std::vector<Ball3<double>> displacements{{{1.2, 0.5, 0}, 0.2}};
  for (const double weight : {0., 0.5, 1.})
    p.ball("ball", flat(displaced_ball<double>(reference, displacements, std::vector{weight})));
  p.ball("outer", flat(displaced_ball<double>(reference, displacements, std::vector{Slab<double>{0, 1}}, std::vector{1.3})));
  p.path("line", {{0, 0}, flat(displacements[0].center)});
}

// Draws a vertex that is in the volume of a joint at rest, and is pulled along by another joint, which turns.
void a4(Plane &p) {
  const Point3D vertex(0, 0, 0);
  const RigidTransform<double> at_rest;
  std::vector<CarriedVolume<double>> volumes{{at_rest, {-0.2, 0, 0}, 0.2, 0.35}, {at_rest, {1.2, 0, 0}, 1.2, 0.35}};
  const std::vector<double> weights{0.85, 0.15};
  std::vector<Point> way;
  for (int i = 0; i <= 8; ++i) {
    const double half = i * 10 * std::numbers::pi / 180;
    volumes[1].joint.rotation = {std::cos(half), 0, 0, std::sin(half)};
    volumes[1].joint.translation = volumes[1].point - rotate<double>(volumes[1].joint.rotation, volumes[1].point);
    way.push_back(flat(skinned_among<double>(volumes, weights, vertex)));
    p.dot("dot", way.back());
  }
  for (const auto &k : volumes) {
    p.ball("outer", {flat(apply(k.joint, k.point)), k.growth});
    p.dot("dot_in", flat(k.point));
  }
  p.ball("ball", flat(mean_ball<double>(volumes, weights)));
  p.path("curve", way);
}

}  // namespace

const std::vector<Drawing> &drawings_of_motion() {
  static const std::vector<Drawing> all{
      {"c1_chord_bound", c1, "A curve, its chord, and balls about the chord that are as large as the curve’s bend allows."},
      {"c2_channel_motion", c2,
       "A cubic spline between two keys stays in the hull of its Bézier points; so do its derivatives in theirs."},
      {"c3_normalized_motion", c3,
       "Blends at equal steps of the weight, and where normalising puts them: the turn is fastest where the blend is "
       "shortest (inner circle)."},
      {"c4_chain_motion", c4,
       "An arm of two hinges at three times, and its hand on the way: near the chord, as far as the bound of its bend "
       "allows."},
      {"c5_skinned_motion", c5,
       "A vertex between two joints that turn, by dual quaternions, and the balls about its chord that hold its way."},
      {"c6_interval_hull", c6,
       "A hand turns from key to key: it leaves the box of the keys (a line here), and stays in that of the interval."},
      {"c7_crossfade", c7,
       "The same joint in two clips, and what lies between: the way of the hand as the weight fades, and its bound."},
      {"c8_any_pose", c8, "An arm in three poses, and the ball that holds it in all: its reach."},
      {"a1_affine_image", a1, "A ball, its image under a scale with shear, and the ball that is said to hold it (dashed)."},
      {"a2_two_phase_skinning", a2, "A reference ball under two scales, and where the weights put a vertex before it is turned."},
      {"a3_morph_displacement", a3,
       "A ball displaced by a morph target of the weights 0, 1/2 and 1, and the ball of all weights between "
       "(dashed)."},
      {"a4_joint_volumes", a4,
       "Two points that joints carry, grown (dashed), and the way of a vertex that the turning one pulls along: it stays in "
       "the ball between them."}};
  return all;
}

}  // namespace refitlab::drawings
