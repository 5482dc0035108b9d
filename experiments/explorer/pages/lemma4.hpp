// SPDX-License-Identifier: GPL-3.0-or-later
// The page of Lemma 4 shows how a ball around unit vectors bounds the directions of their blends.
#pragma once

#include "algorithms/runtime/balls/mean_ball.hpp"
#include "experiments/explorer/pages/page.hpp"
#include "lemmas/lemma2_normalization.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"

namespace refitlab::explorer {

inline Page lemma4_page() {
  return {"lemma4",
          "Lemma 4: a ball bounds the blends of quaternions",
          "The mean ball E around unit quaternions cuts a cap from the sphere. Every blend b, brought back to the sphere, lies "
          "in it. The printed condition r < 1 is more than is needed: three equal quaternions and one turned away have r = 6/5 "
          "and a good cap. Too wide a ball, however, bounds nothing.",
          {{"first turned by", 0, half_turn, 12, circle_text},
           {"second turned by", 0, half_turn, 10, circle_text},
           {"copies of 1", 1, 3, 1, plain_text},
           {"weight of the first", 0, 10, 4, plain_text},
           {"weight of the second", 0, 10, 3, plain_text}},
          {{"a cap", {12, 10, 1, 4, 3}},
           {"r = 6/5 and a good cap", {16, 0, 2, 8, 0}},
           {"a blend outside the cap", {24, 24, 3, 5, 5}}}};
}

template <class S>
void lemma4_scene(const Values& k, Scene<S>& scene) {
  const Vec<S, 2> first = on_circle<S>(k[0]), second = on_circle<S>(k[1]);
  VecList<S, 3> units(k[2], vec3<S>(1, 0, 0));
  units.push_back({first[0], first[1], S(0)});
  units.push_back({second[0], S(0), second[1]});
  const std::span<const Vec<S, 3>> points(units);
  SquaredBall<S, 3> ball{mean_center(points), S(0)};
  ball.squared_radius = farthest_squared_distance(ball.center, points);
  std::vector<S> weights(units.size(), S(0));
  const int sum = std::max({10, k[3] + k[4]});
  weights[0] = S(sum - k[3] - k[4]) / S(sum);
  weights[units.size() - 2] = S(k[3]) / S(sum);
  weights.back() = S(k[4]) / S(sum);
  const auto element = hull_element(ball, units, weights);

  const auto origin = vec3<S>(0, 0, 0);
  scene.ball("surface", unit_sphere<S>());
  scene.ball("ball", ball);
  scene.point("center", "c", ball.center);
  if (less(S(0), squared_norm(ball.center)) == Verdict::holds) {
    const auto h = intersection_cap(unit_sphere<S>(), ball).half_space;
    scene.plane("half_space", h);
    scene.half_space_cap("cap", h);
  }
  for (std::size_t i = static_cast<std::size_t>(k[2]) - 1; i < units.size(); ++i) {
    scene.point("quaternion", i + 1 == static_cast<std::size_t>(k[2]) ? "1" : i + 1 == units.size() ? "n2" : "n1", units[i]);
    scene.line("hull", units[i], i + 1 < units.size() ? units[i + 1] : units[0]);
  }
  const Verdict in_cap = element.verdict;
  scene.line("ray", origin, element.blend);
  scene.point("blend", "b", element.blend);
  scene.direction(in_cap == Verdict::holds ? "inside" : "outside", "b / ‖b‖", element.blend);

  scene.number("r squared", ball.squared_radius);
  scene.number("1 + ‖c‖² − r²", scaled_distance(ball.center, ball.squared_radius));
  scene.verdict("", "r < 1, as printed", less(ball.squared_radius, S(1)));
  scene.verdict("", "r² ≤ 1 + ‖c‖², or E holds the sphere", ball_keeps_hulls(ball));
  scene.verdict("", "b / ‖b‖ is in the cap", in_cap);
  scene.verdict("printed", "if r < 1, every blend is in the cap", hull_stays_in_cap_printed<S, 3>(ball, units, weights));
  scene.verdict("printed", "no ball with r ≥ 1 bounds the blends", radius_below_one_is_needed_printed(ball));
  scene.verdict("repaired", "if r² ≤ 1 + ‖c‖², every blend is in the cap",
                hull_stays_in_cap_repaired<S, 3>(ball, units, weights));
  scene.verdict("repaired", "b / ‖b‖ or its negative is in E, always",
                rotations_stay_in_cap_repaired<S, 3>(ball, units, weights));
}

}  // namespace refitlab::explorer
