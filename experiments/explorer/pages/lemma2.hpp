// SPDX-License-Identifier: GPL-3.0-or-later
// The page of Lemma 2 shows a convex hull, and that of its normalised generators.
#pragma once

#include "experiments/explorer/pages/page.hpp"
#include "lemmas/lemma2_normalization.hpp"

namespace refitlab::explorer {

inline Page lemma2_page() {
  return {"lemma2",
          "Lemma 2: normalising keeps the rotations of a hull",
          "Three quaternions of different lengths, and the same on the sphere. A blend a of the first has a partner b on the "
          "same ray in the hull of the second: the same rotation. Unless the hull holds 0, which is no rotation at all, as the "
          "printed lemma forgets.",
          {{"angle between them", 1, half_turn, 10, circle_text},
           {"length of the second", 2, 20, 15, tenths_text},
           {"weight 1", 0, 10, 3, plain_text},
           {"weight 2", 0, 10, 3, plain_text},
           {"weight 3", 0, 10, 4, plain_text}},
          {{"a blend and its partner", {10, 15, 3, 3, 4}}, {"the blend vanishes", {24, 10, 6, 5, 5}}}};
}

template <class S>
void lemma2_scene(const Values& k, Scene<S>& scene) {
  const Vec<S, 2> c = on_circle<S>(k[0]);
  const std::vector<S> lengths{S(1), S(k[1]) / S(10), S(1)};
  const VecList<S, 3> units{vec3<S>(1, 0, 0), {c[0], c[1], S(0)}, {c[0], S(-c[1]), S(0)}};
  VecList<S, 3> vectors;
  for (std::size_t i = 0; i < units.size(); ++i) vectors.push_back(units[i] * lengths[i]);
  const int sum = std::max(1, k[2] + k[3] + k[4]);
  const std::vector<S> weights{k[2] + k[3] + k[4] ? S(S(k[2]) / S(sum)) : S(1), S(k[3]) / S(sum), S(k[4]) / S(sum)};

  const auto origin = vec3<S>(0, 0, 0);
  const Vec<S, 3> a = combine<S, 3>(weights, vectors);
  const auto partner = weights_on_same_ray(weights, lengths);
  const Vec<S, 3> b = combine<S, 3>(partner.weights, units);
  scene.ball("surface", unit_sphere<S>());
  for (std::size_t i = 0; i < units.size(); ++i) {
    scene.line("normal", origin, vectors[i]);
    scene.line("hull", vectors[i], vectors[(i + 1) % 3]);
    scene.line("other_hull", units[i], units[(i + 1) % 3]);
    scene.point("quaternion", "q" + std::to_string(i + 1), vectors[i]);
    if (lengths[i] != S(1)) scene.point("unit", "n" + std::to_string(i + 1), units[i]);
  }
  scene.line("ray", origin, a);
  scene.line("ray", origin, b);
  scene.point("blend", "a", a);
  scene.point("partner", "b", b);

  scene.number("scale k, a = k b", partner.scale);
  scene.verdict("", "the blend is not 0", less(S(0), squared_norm(a)));
  scene.verdict("printed", "a is a rotation, and b the same",
                normalisation_keeps_rotations_printed<S, 3>(vectors, lengths, weights));
  scene.verdict("repaired", "if a is not 0, b is the same rotation",
                normalisation_keeps_rotations_repaired<S, 3>(vectors, lengths, weights));
  scene.verdict("repaired", "both hulls span the same rays", normalisation_keeps_rays_repaired<S, 3>(vectors, lengths, weights));
}

}  // namespace refitlab::explorer
