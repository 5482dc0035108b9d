// SPDX-License-Identifier: GPL-3.0-or-later
// The page of Lemma 1 shows how a half-space cuts a cap from the unit sphere.
#pragma once

#include "experiments/explorer/pages/page.hpp"
#include "lemmas/lemma1_cap_definitions.hpp"

namespace refitlab::explorer {

inline Page lemma1_page() {
  return {"lemma1",
          "Lemma 1: two definitions of a cap",
          "A half-space (x, d) ≥ D cuts a cap from the sphere; an apex and an angle describe the same cap. Push the plane until "
          "the half-space holds the whole sphere: no angle has the cosine that the printed lemma asks for. Or let the scalar be "
          "negative: the printed “any non-zero scalar” turns the cap round.",
          {{"offset D", -20, 20, 5, tenths_text},
           {"length of d", 1, 20, 10, tenths_text},
           {"sign of the scalar", 0, 1, 1, [](int k) { return std::string(k ? "positive" : "negative"); }},
           {"point x, from the apex", 0, half_turn, 5, circle_text}},
          {{"a cap", {5, 10, 1, 5}},
           {"the whole sphere is in the half-space", {-20, 10, 1, 10}},
           {"a negative scalar", {5, 10, 0, 4}},
           {"no cap at all", {15, 10, 1, 5}}}};
}

template <class S>
void lemma1_scene(const Values& k, Scene<S>& scene) {
  const Vec<S, 3> unit = vec3<S>(2, 2, 1) / S(3), across = vec3<S>(1, -2, 2) / S(3);
  const S length = S(k[1]) / S(10), scale = S(1) / length, scalar = k[2] ? scale : S(-scale);
  const HalfSpace<S, 3> h{unit * length, S(k[0]) / S(10)};
  const Vec<S, 2> turn = on_circle<S>(k[3]);
  const Vec<S, 3> x = unit * turn[0] + across * turn[1];
  const auto surface = unit_sphere<S>();

  const Verdict meets_it = meets(surface, h);
  scene.ball("surface", surface);
  scene.plane("half_space", h);
  scene.line("normal", vec3<S>(0, 0, 0), h.normal);
  const auto made = cap_of_half_space(surface, h, scale);
  if (meets_it == Verdict::holds) {
    scene.cap("cap", made.cap);
    scene.point("apex", "a", made.cap.apex);
  }
  scene.point(contains(h, x) == Verdict::holds ? "inside" : "outside", "x", x);

  scene.number("cos α", made.cap.cos_angle);
  scene.verdict("", "the half-space meets the sphere", meets_it);
  scene.verdict("", "x is in the half-space", contains(h, x));
  scene.verdict("", "x is within the angle of the apex", within_angle(made.cap, x));
  scene.verdict("printed", "the scalar gives an angle, and both definitions agree on x",
                half_space_is_cap_printed(surface, h, scalar, x));
  scene.verdict("repaired", "if they meet, the cap exists and both definitions agree on x",
                half_space_is_cap_repaired(surface, h, scale, x));
}

}  // namespace refitlab::explorer
