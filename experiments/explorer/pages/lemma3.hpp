// SPDX-License-Identifier: GPL-3.0-or-later
// The page of Lemma 3 shows where a ball cuts the unit sphere.
#pragma once

#include "experiments/explorer/pages/page.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"

namespace refitlab::explorer {

inline Page lemma3_page() {
  return {"lemma3",
          "Lemma 3: a ball cuts a cap from the sphere",
          "The ball B cuts the unit sphere; the plane through the cut bounds a half-space with the same points of the sphere in "
          "it, and its distance d_H from 0 is known. Pull the ball away or shrink it inside: nothing is cut, and nothing is no "
          "cap. With the centers in one point there is no plane.",
          {{"distance of the centers", 0, 30, 8, tenths_text},
           {"radius of the ball", 0, 20, 7, tenths_text},
           {"point x, from the axis", 0, half_turn, 3, circle_text}},
          {{"a cap", {8, 7, 3}},
           {"the ball is inside", {5, 2, 3}},
           {"the ball is away", {30, 5, 3}},
           {"one center", {0, 10, 3}},
           {"0 is in the half-space", {6, 14, 20}}}};
}

template <class S>
void lemma3_scene(const Values& k, Scene<S>& scene) {
  const Vec<S, 3> unit = vec3<S>(2, 2, 1) / S(3), across = vec3<S>(1, -2, 2) / S(3);
  const S delta = S(k[0]) / S(10);
  const SquaredBall<S, 3> surface = unit_sphere<S>(), ball{unit * delta, sq(S(S(k[1]) / S(10)))};
  const Vec<S, 2> turn = on_circle<S>(k[2]);
  const Vec<S, 3> x = unit * turn[0] + across * turn[1];

  const Verdict eccentric = are_eccentric(surface, ball), meet = surface_meets_ball(surface, ball);
  scene.ball("surface", surface);
  scene.ball("ball", ball);
  scene.point("center", "b", ball.center);
  if (eccentric == Verdict::holds) {
    const auto made = intersection_cap(surface, ball);
    const auto nearest = nearest_point_of_intersection_cap(surface, ball);
    scene.plane("half_space", made.half_space);
    scene.line("normal", surface.center, nearest.foot);
    scene.point("foot", "d_H", nearest.foot);
    if (meet == Verdict::holds) scene.cap("cap", cap_of_half_space(surface, made.half_space, S(S(1) / (S(2) * delta))).cap);
    scene.number("d_H squared", nearest.squared_distance);
  }
  scene.point(encloses(ball, x) == Verdict::holds ? "inside" : "outside", "x", x);

  scene.verdict("", "the centers differ", eccentric);
  scene.verdict("", "the ball meets the sphere", meet);
  scene.verdict("", "x is in the ball", encloses(ball, x));
  scene.verdict("printed", "what they have in common is a cap", intersection_is_cap_printed(surface, ball, x));
  scene.verdict("printed", "a radius below 1 makes d_H the distance", intersection_distance_printed(ball));
  scene.verdict("repaired", "if they differ and meet, it is a cap", intersection_is_cap_repaired(surface, ball, x));
  scene.verdict("repaired", "d_H is the distance while 0 is outside the half-space",
                intersection_distance_repaired(surface, ball));
}

}  // namespace refitlab::explorer
