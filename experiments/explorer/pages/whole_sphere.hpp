// SPDX-License-Identifier: GPL-3.0-or-later
// The page of section 4.3 goes from quaternions in a ball to the ball around a rotated point. It shows when nothing but the whole
// sphere will do.
#pragma once

#include "algorithms/runtime/balls/mean_ball.hpp"
#include "experiments/explorer/pages/page.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/s43_whole_sphere_fallback.hpp"

namespace refitlab::explorer {

inline Page whole_sphere_page() {
  return {"whole_sphere",
          "Section 4.3: when only the whole sphere will do",
          "Left, quaternions (the slice w, x, y of S₃): their mean ball E cuts a cap. Right, the space of the model: the cap of "
          "all rotations of a vector v, at twice the angle, and the ball around it. With a wide E the printed line 15 makes a "
          "ball of negative radius or one that misses the rotated v; the repaired step takes the whole sphere.",
          {{"turn of the last quaternion", 0, half_turn, 8, circle_text},
           {"copies of 1", 1, 3, 1, plain_text},
           {"blend", 0, 10, 5, [](int k) { return std::to_string(10 * k) + " %"; }}},
          {{"a small turn", {8, 1, 5}},
           {"the ball misses it", {7, 3, 3}},
           {"r = 6/5, still a cap", {16, 3, 8}},
           {"a negative radius", {36, 3, 10}}}};
}

template <class S>
void whole_sphere_scene(const Values& k, Scene<S>& scene) {
  const Vec<S, 2> turn = on_circle<S>(k[0]);
  std::vector<Quaternion<S>> units(k[1], identity_quaternion<S>());
  units.push_back({turn[0], S(0), turn[1], S(0)});
  const std::span<const Quaternion<S>> list(units);
  const Quaternion<S> center = mean_center(list);
  const S squared_radius = farthest_squared_distance(center, list);
  const S share = S(k[2]) / S(10);
  const Quaternion<S> blend = units[0] * S(S(1) - share) + units.back() * share;
  const auto slice = [](const Quaternion<S>& q) { return Vec<S, 3>(q[1], q[2], q[0]); };

  scene.move_right(-1.5);
  const auto surface = unit_sphere<S>();
  const SquaredBall<S, 3> ball{slice(center), squared_radius};
  scene.ball("surface", surface);
  scene.ball("ball", ball);
  scene.point("quaternion", "1", slice(units[0]));
  scene.point("quaternion", "q", slice(units.back()));
  scene.line("hull", slice(units[0]), slice(units.back()));
  scene.point("center", "c", slice(center));
  scene.point("blend", "b", slice(blend));
  if (less(S(0), squared_norm(center)) == Verdict::holds) {
    const HalfSpace<S, 3> h{slice(center) * S(2), scaled_distance(center, squared_radius)};
    scene.plane("half_space", h);
    scene.half_space_cap("cap", h);
  }

  scene.move_right(1.5);
  const Vec<S, 3> v = vec3<S>(2, 1, 2) / S(3);
  const auto bound = rotated_vectors_cap_repaired(center, squared_radius);
  const Vec<S, 3> apex = rotate_by<S>(bound.apex, v);
  const Cap<S, 3> cap{vec3<S>(0, 0, 0), apex, bound.cos_angle};
  scene.ball("surface", surface);
  scene.cap("cap", cap);
  scene.ball("repaired", cap_ball_repaired(cap));
  const Verdict printed_ball = line_15_makes_ball_printed(center, squared_radius);
  SquaredBall<S, 3> printed{vec3<S>(0, 0, 0), S(-1)};
  if (printed_ball == Verdict::holds) {
    const S cosine = sq(scaled_distance(center, squared_radius)) / (S(2) * squared_norm(center)) - S(1);
    printed = cap_ball_printed(Cap<S, 3>{vec3<S>(0, 0, 0), rotate_by<S>(center, v), cosine});
    scene.ball("printed", printed);
  }
  const bool is_rotation = less(S(0), squared_norm(blend)) == Verdict::holds;
  scene.point("center", "v", v);
  if (is_rotation) {
    const Vec<S, 3> rotated = rotate_by<S>(blend, v);
    const Verdict in_printed = encloses(printed, rotated);
    scene.point(in_printed == Verdict::holds ? "inside" : "outside", "R_b v", rotated);
    scene.verdict("printed", "its ball encloses R_b v", in_printed);
    scene.verdict("repaired", "R_b v is in the cap", rotated_blend_is_bounded(bound, blend, v));
    scene.verdict("repaired", "the ball encloses R_b v", encloses(cap_ball_repaired(cap), rotated));
  }
  scene.number("r_E squared", squared_radius);
  scene.number("cos α", bound.cos_angle);
  scene.verdict("", "the ball makes a cap: r² < 1 + ‖c‖²", ball_makes_cap(center, squared_radius));
  scene.verdict("", "printed: r ≥ 1 asks for the whole sphere", fallback_is_needed_printed(squared_radius));
  scene.verdict("printed", "line 15 makes a ball", printed_ball);
}

}  // namespace refitlab::explorer
