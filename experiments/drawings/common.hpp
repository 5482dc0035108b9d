// SPDX-License-Identifier: GPL-3.0-or-later
// The drawings share rotations about z, the unit circle and the pictures with which several lemmas begin.
//
// Lemmas of R^d are drawn for d = 2. In those of rotations all joints turn about z, so that points stay in the plane, and a
// quaternion is its (w, z).
#pragma once

#include <numbers>

#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/balls/mean_ball.hpp"
#include "experiments/drawings/drawings.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace refitlab::drawings {

using Quat = Quaternion<double>;
using Point3D = Vec<double, 3>;

inline const SquaredBall<double, 2> unit_circle{{0, 0}, 1};
inline Point flat(const Point3D &p) { return {p[0], p[1]}; }
inline SquaredBall<double, 2> flat(const SquaredBall<double, 3> &b) { return {flat(b.center), b.squared_radius}; }
inline SquaredBall<double, 2> flat(const Ball3<double> &b) { return {flat(b.center), sq(b.radius)}; }
inline Point on_circle(double degrees) { return Plane::turned({1, 0}, degrees * std::numbers::pi / 180); }
// Returns the rotation by this angle about z.
inline Quat turn(double degrees) {
  const Point half = on_circle(degrees / 2);
  return {half[0], 0, 0, half[1]};
}
inline Point slice(const Quat &q) { return {q[0], q[3]}; }

inline SquaredBall<double, 2> mean_ball_of(const std::vector<Point> &points) {
  return squared(mean_ball<double, 2>(std::span<const Point>(points)));
}

inline void draw_surface_and_cap(Plane &plane, const SquaredBall<double, 2> &ball) {
  plane.circle("surface", {0, 0}, 1);
  const auto h = intersection_cap(unit_circle, ball).half_space;
  const auto made = cap_of_half_space_by_root(unit_circle, h);
  if (made.verdict == Verdict::holds) plane.cap(made.cap);
  plane.border(h);
}

inline void draw_hull_in_cap(Plane &p, const std::vector<Point> &units) {
  const auto ball = mean_ball_of(units);
  draw_surface_and_cap(p, ball);
  p.ball("ball", ball);
  p.path("hull", units, true);
  std::vector<double> w(units.size(), 0.2 / static_cast<double>(units.size() - 2));
  w.front() = 0.45, w.back() = 0.35;
  const auto element = hull_element(ball, units, w);
  p.path("curve", {{0, 0}, direction_by_root(element.blend)});
  for (const Point &n : units) p.dot("dot", n);
  p.dot("dot_in", element.blend, "b"), p.dot("dot_in", direction_by_root(element.blend)), p.dot("dot", ball.center, "c");
}
inline void draw_balls_and_theirs(Plane &p, const std::vector<Ball3<double>> &balls) {
  for (const auto &b : balls) p.ball("ball", flat(b)), p.dot("dot", flat(b.center));
  p.ball("outer", flat(few_balls_enclosing(balls)));
}

}  // namespace refitlab::drawings
