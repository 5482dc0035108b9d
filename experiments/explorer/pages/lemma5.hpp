// SPDX-License-Identifier: GPL-3.0-or-later
// The page of Lemma 5 shows the smallest ball around a cap, printed and repaired.
#pragma once

#include "experiments/explorer/pages/page.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

namespace refitlab::explorer {

inline Page lemma5_page() {
  return {"lemma5",
          "Lemma 5: the smallest ball around a cap",
          "The printed ball sits over the rim of the cap. Open the angle beyond 90°: its center slides behind the middle of the "
          "sphere and it lets go of the apex. The repaired ball stops there and keeps the whole cap. This is what breaks "
          "Algorithm 1.",
          {{"angle α", 0, half_turn, 8, circle_text}, {"point x, from the apex (0) to the rim (10)", 0, 10, 10, plain_text}},
          {{"a narrow cap", {6, 10}},
           {"exactly 90°", {12, 10}},
           {"beyond 90°: the apex escapes", {24, 10}},
           {"the whole sphere", {half_turn, 10}}}};
}

template <class S>
void lemma5_scene(const Values& k, Scene<S>& scene) {
  const Vec<S, 3> unit = vec3<S>(2, 2, 1) / S(3), across = vec3<S>(1, -2, 2) / S(3);
  const Vec<S, 2> angle = on_circle<S>(k[0]);
  const Cap<S, 3> cap{vec3<S>(0, 0, 0), unit, angle[0]};
  // Half an angle's tangent times a share below 1 gives a point of the cap.
  const S t = k[0] == half_turn ? S(k[1]) : S(S(k[0]) * S(k[1]) / S(120)), n = S(1) + t * t;
  const Vec<S, 2> at = k[1] == 10 ? angle : Vec<S, 2>((S(1) - t * t) / n, S(2) * t / n);
  const Vec<S, 3> x = unit * at[0] + across * at[1];
  const auto printed = cap_ball_printed(cap), repaired = cap_ball_repaired(cap);
  const auto smallest = smallest_cap_ball(cap, angle[1], across);

  scene.ball("surface", unit_sphere<S>());
  scene.cap("cap", cap);
  scene.ball("printed", printed);
  scene.ball("repaired", repaired);
  scene.line("rim", smallest.first, smallest.second);
  scene.point("center", "repaired center", repaired.center);
  if (printed.center != repaired.center) scene.point("printed_center", "printed center", printed.center);
  scene.point(encloses(printed, cap.apex) == Verdict::holds ? "inside" : "outside", "apex", cap.apex);
  scene.point(encloses(printed, x) == Verdict::holds ? "inside" : "outside", "x", x);

  scene.number("cos α", cap.cos_angle);
  scene.number("printed radius squared", printed.squared_radius);
  scene.number("repaired radius squared", repaired.squared_radius);
  scene.verdict("printed", "the ball encloses the apex", cap_ball_encloses_printed(cap, cap.apex));
  scene.verdict("printed", "the ball encloses x", cap_ball_encloses_printed(cap, x));
  scene.verdict("repaired", "the ball encloses the apex", cap_ball_encloses_repaired(cap, cap.apex));
  scene.verdict("repaired", "the ball encloses x", cap_ball_encloses_repaired(cap, x));
  scene.verdict("repaired", "no smaller ball does", is_smallest_cap_ball(cap, smallest));
}

}  // namespace refitlab::explorer
