// SPDX-License-Identifier: GPL-3.0-or-later
// States how loose the repaired Algorithm 1 is, where two or three weight vertices are blended.
//
// The first theorem, "two_hold", is about two joints and all that is between. Frames can be chosen so that the quaternions q'_k
// at both ends of the interval of weights are (1, 0, 0, -T) and (1, 0, 0, T) up to factors, T = tan(t/4) for a relative rotation
// by t. All blends are (1, 0, 0, s T) up to factors, -1 <= s <= 1. So T in [0, 1] has all pairs of joints up to half a turn apart
// with all intervals of weights. The vertex is x = (1, 0, 0), across the axis: for x = a + p with a along the axis, the squared
// distance of R_q x from the center k R_apex x less the ball's squared radius (1 - k^2) ||x||^2 is that of p and 2 k (k - 1)
// ||a||^2 <= 0 more. Both ends are on the ball's surface, so intervals prove that it holds the rest with a factor above 1 only.
//
// The second, "two_tight", is about two joints, as tight as can be. Here the frame is that of the first end, so both are (1, 0,
// 0, 0) and (1 - T^2, 0, 0, 2 T) up to factors. The rotation center of least squares is on the axis of the relative motion, so
// its images are h apart along the axis. The vertex, as seen from the center, is x = (1, 0, 0) up to scale and frame, if it is
// across the axis. What a vertex has along the axis changes nothing about the true motion, but makes the bound looser without
// limit (b5_rotation_axis), so the statement is about vertices across the axis. Any ball that holds both ends of the true motion
// has at least half of their distance for a radius. The bound's ball is that around two balls of one radius R, which are h apart:
// R + h/2. Let A be half of the ends' distance across the axis, so R >= A: (R + h/2)^2 / (A^2 + h^2/4) falls from h/2 = A on, and
// A <= 2 T. So some h = 2 k T with k in [0, 2] has the greatest. With R = A and h/2 = A it is sqrt 2.
//
// In all of them, T >= 2^-8 leaves out relative rotations by less than 0.9 degrees, where all distances vanish.
//
// The third is about three weight vertices. Their unit quaternions n_k are moved by an isometry of R^4, which changes no dot
// product, to the directions of (1, 0, 0, 0), (1, y, 0, 0), (1, p y, q y, 0), q >= 0, numbered so that the first two are farthest
// apart, by y = tan(t/2) for a relative rotation t. Of these (n_1, n_3) >= (n_1, n_2) gives p^2 + q^2 <= 1, and (n_2, n_3) >=
// (n_1, n_2) gives p >= 0. A ball that holds R_1 x and R_2 x, x across the axis of the relative rotation, has a radius of at
// least sin(t/2) ||x||. The cap is that about the mean, as in Algorithm 1.
#include "lemmas/rotation_bound.hpp"

#include <array>

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "proptests/exhaustive/theorems.hpp"

namespace proptests::exhaustive {
namespace {

using namespace refitlab;

Judgement two_joints_are_tight(std::span<const Interval> at, const Interval& k) {
  const Interval zero(0), one(1);
  const Interval& t = at[0];
  const SphericalBlend<Interval> blend{{{one, zero, zero, zero}, {one - sq(t), zero, zero, Interval(2) * t}},
                                       {{zero, zero, zero}, {zero, zero, Interval(2) * at[1] * t}},
                                       {one, zero, zero}};
  const std::array<Quaternion<Interval>, 2> units{blend.rotations[0], direction_by_root(blend.rotations[1])};
  const Quaternion<Interval> sum = units[0] + units[1];
  const Interval apart = norm<Interval, 3>(blend.center_images[1] - blend.center_images[0]);
  const Interval diameter = Interval(2) * rotated_ball(bound_rotations<Interval>(units, sum), blend.x).radius + apart;
  const auto place_at = [&](const std::array<Interval, 2>& u) {
    const ScaledPoint<Interval> place = blend.at(u);
    return Vec<Interval, 3>(place.numerator / place.denominator);
  };
  return at_most(sq(diameter), sq(k) * squared_distance<Interval, 3>(place_at({one, zero}), place_at({zero, one})));
}

Judgement two_joints_are_held(std::span<const Interval> at, const Interval& k) {
  const Interval zero(0), one(1);
  const Interval& t = at[0];
  const std::array<Quaternion<Interval>, 2> units{direction_by_root(Quaternion<Interval>{one, zero, zero, -t}),
                                                  direction_by_root(Quaternion<Interval>{one, zero, zero, t})};
  const Quaternion<Interval> sum = units[0] + units[1], blend{one, zero, zero, at[1] * t};
  const Vec<Interval, 3> x{one, zero, zero};
  const Ball3<Interval> ball = rotated_ball(bound_rotations<Interval>(units, sum), x);
  const Vec<Interval, 3> image = rotate_scaled(blend, x) / squared_norm(blend);
  return at_most(squared_distance<Interval, 3>(image, ball.center), sq(k) * sq(ball.radius));
}

Judgement three_vertices_are_tight(std::span<const Interval> at, const Interval& k) {
  const Interval zero(0), one(1);
  const Interval &y = at[0], p = at[1] * y, q = at[2] * y;
  const std::array<Quaternion<Interval>, 3> units{Quaternion<Interval>{one, zero, zero, zero},
                                                  direction_by_root(Quaternion<Interval>{one, y, zero, zero}),
                                                  direction_by_root(Quaternion<Interval>{one, p, q, zero})};
  // This checks (n_1, n_3) >= (n_1, n_2) and (n_2, n_3) >= (n_1, n_2), without roots.
  const Interval far = one + sq(y), near = one + sq(p) + sq(q);
  if (fails(less_equal(near, far)) || fails(less_equal(near, sq(Interval(one + y * p))))) return outside();
  const Quaternion<Interval> sum = units[0] + units[1] + units[2];
  return at_most(sq(bound_rotations<Interval>(units, sum).radius_ratio) * far, sq(k) * sq(y));
}

}  // namespace

std::vector<Theorem> theorems_of_rotation_bound() {
  return {{"rotation_bound.two_hold",
           "For two joints up to half a turn apart, at least 0.9 degrees, all of their blends q and all vertices x: the distance "
           "of R_q x from the center of the ball of "
           "Algorithm 1 repaired is at most K times its radius.",
           {{"T", 0x1p-8, 1, true}, {"s", -1, 1}},
           1 + 0x1p-4,
           1 + 0x1p-7,
           1,
           two_joints_are_held},
          {"rotation_bound.two_tight",
           "For two joints up to half a turn apart with a least-squares rotation center, every interval of weights between whose "
           "ends the rotation "
           "turns by 0.9 degrees or more, every screw, and every vertex across its axis: the ball of Algorithm 1 repaired has at "
           "most K times the radius of "
           "the smallest ball of all places of the vertex.",
           {{"T", 0x1p-8, 1, true}, {"k", 0, 2}},
           1.5,
           1.421875,
           1.41421356,
           two_joints_are_tight},
          {"rotation_bound.three",
           "For three weight vertices, the farthest two of which are rotations by t apart, 0.12 <= t <= 120 degrees: the ball in "
           "which Algorithm 1 repaired "
           "with the mean holds all R_q x has at most the radius K sin(t/2) ||x||. sin(t/2) ||x|| is what these two need, for "
           "some x.",
           {{"y", 0x1p-10, 1.75, true}, {"p", 0, 1}, {"q", 0, 1}},
           1.375,
           1.34375,
           4.0 / 3,
           three_vertices_are_tight}};
}

}  // namespace proptests::exhaustive
