// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {

SkinningDetector::SkinningDetector(const Character& character, Placing placing)
    : character_(character),
      placing_(placing),
      palette_packs_(character.mesh, character.sets, Skinning::spherical),
      packed_(character.mesh, character.sets),
      sides_{{.is_placed = FrameStamps(character.mesh.vertices.size())},
             {.is_placed = FrameStamps(character.mesh.vertices.size())}} {
  for (Side& s : sides_) s.skinned.resize(character.mesh.vertices.size()), s.placed.resize(character.mesh.vertices.size());
}

void SkinningDetector::palette(const ScenarioFrame& frame) {
  const Pose* const poses[] = {&frame.first, &frame.second};
  const RigidTransform<double>* const placements[] = {&frame.first_at, &frame.second_at};
  for (int i = 0; i < 2; ++i) {
    palette_packs_.make(*poses[i], sides_[i].palette);
    sides_[i].placement = *placements[i];
    sides_[i].is_placed.begin();
  }
}

void SkinningDetector::skin() {
  for (Side& s : sides_) {
    packed_.skin_all(s.palette, Skinning::spherical, s.skinned);
    counts_.vertices_skinned += static_cast<long>(s.skinned.size());
    if (placing_ == Placing::all)
      for (std::size_t v = 0; v < s.skinned.size(); ++v) s.placed[v] = apply(s.placement, s.skinned[v]);
  }
}

TrianglePoints SkinningDetector::in_world(Side& s, int triangle) {
  const Triangle& t = character_.mesh.triangles[triangle];
  if (placing_ == Placing::when_asked)
    for (const int v : t)
      if (!s.is_placed.is_made(v)) {
        s.placed[v] = apply(s.placement, s.skinned[v]);
        s.is_placed.mark(v);
      }
  return {s.placed[t[0]], s.placed[t[1]], s.placed[t[2]]};
}

bool SkinningDetector::touch(int first, int second) {
  ++counts_.triangle_tests;
  return triangles_meet(in_world(sides_[0], first), in_world(sides_[1], second));
}

}  // namespace refitlab
