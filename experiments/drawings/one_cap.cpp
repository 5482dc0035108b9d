// SPDX-License-Identifier: GPL-3.0-or-later
// These are the drawings of caps without normalisation and without a ball.
#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "experiments/drawings/common.hpp"
#include "lemmas/rotation_bound.hpp"
#include "lemmas/s43_rotated_cap.hpp"
#include "lemmas/t3_min_dot_distance.hpp"
#include "lemmas/t3_one_cap.hpp"

namespace refitlab::drawings {
namespace {

void t3_min_dot(Plane &p) {
  const std::vector<Point> units{on_circle(-50), on_circle(10), on_circle(65)};
  const auto ball = mean_ball_of(units);
  const auto least = min_dot_distance<double, 2>(units, ball.center, ball.squared_radius);
  draw_surface_and_cap(p, ball);
  const Point axis = ball.center.normalized();
  for (const Point &n : units) p.path("line", {n, axis * n.dot(axis)}), p.dot("dot", n);
  p.dot("dot_in", units[least.nearest], "the least"), p.dot("dot", ball.center, "c");
}

void t3_one_cap(Plane &p) {
  const std::vector<Quat> list{turn(-60) * 1.5, turn(20) * 0.6, turn(90) * 1.2};
  const Quat axis = turn(20);
  p.circle("surface", {0, 0}, 1);
  p.cap({{0, 0}, slice(axis), std::sqrt(squared_cap_cosine<double>(list, axis))});
  std::vector<Point> hull;
  for (const Quat &q : list) hull.push_back(slice(q)), p.path("line", {{0, 0}, slice(q)});
  p.path("hull", hull, true);
  for (const Point &q : hull) p.dot("dot", q, "q'");
  p.dot("dot_in", slice(axis), "c");
}

void t3_smallest(Plane &p) {
  const std::vector<Point> units{on_circle(-10), on_circle(0), on_circle(8), on_circle(100)};
  const auto ball = smallest_ball<double, 2>(units);
  p.ball("outer", mean_ball_of(units));
  const SquaredBall<double, 2> smallest{ball.center, ball.squared_radius};
  draw_surface_and_cap(p, smallest);
  p.ball("ball", smallest);
  p.path("line", {{0, 0}, ball.center});
  for (const Point &n : units) p.dot("dot", n);
  p.dot("dot_in", ball.center, "smallest");
}

void rotation(Plane &p) {
  const std::vector<Quat> units{turn(-20), turn(15), turn(70)};
  const Vec<double, 3> x(1, 0, 0);
  const auto bound = bound_rotations<double>(units, Quat(units[0] + units[1] + units[2]));
  const Point at_apex = flat(rotate(bound.apex, x));
  p.circle("surface", {0, 0}, 1);
  p.ball("ball", flat(rotated_ball(bound, x)));
  p.cap({{0, 0}, at_apex, 1 - rotated_cap_versine(squared_half_chord<double>(units, bound.apex))});
  for (const Quat &q : units) {
    const Point image = flat(rotate(q, x));
    p.path("line", {at_apex, image}), p.dot("dot", image);
  }
  p.dot("dot_in", at_apex, "apex");
}

}  // namespace

const std::vector<Drawing> &drawings_of_one_cap() {
  static const std::vector<Drawing> all{{"t3_min_dot_distance", t3_min_dot,
                                         "The cap’s half-space is as far from 0 as the least of the dot products "
                                         "with the center’s direction."},
                                        {"t3_one_cap", t3_one_cap,
                                         "Quaternions of different lengths, not normalised: the cap about c "
                                         "(yellow) holds the directions of their whole "
                                         "hull."},
                                        {"t3_smallest_ball_smallest_cap", t3_smallest,
                                         "The smallest ball of the units makes the smallest cap (yellow). Three "
                                         "that are close drag the mean ball "
                                         "(dashed) along."},
                                        {"rotation_bound", rotation,
                                         "Where three rotations carry a vector: the longest chord from the "
                                         "apex makes the cap (yellow), and the cap its ball."}};
  return all;
}

}  // namespace refitlab::drawings
