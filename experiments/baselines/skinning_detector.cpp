// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

std::vector<int> places_of(const PackedVertices& packed, std::size_t vertex_count) {
  std::vector<int> out(vertex_count);
  const std::span<const int> vertices = packed.vertices(0);
  for (std::size_t place = 0; place < vertices.size(); ++place) out[vertices[place]] = static_cast<int>(place);
  return out;
}

}  // namespace

SkinningDetector::SkinningDetector(const Character& character, Placing placing)
    : candidates_(character.mesh, [this](int side, int vertex) -> const PaddedVertex& { return vertex_in_world(side, vertex); }),
      character_(character),
      placing_(placing),
      palette_packs_(character.mesh, character.sets, Skinning::spherical),
      packed_(character.mesh, character.sets),
      place_of_(places_of(packed_, character.mesh.vertices.size())),
      sides_{{.is_placed = FrameStamps(character.mesh.vertices.size())},
             {.is_placed = FrameStamps(character.mesh.vertices.size())}} {
  for (Side& s : sides_) {
    s.skinned.resize(character.mesh.vertices.size()), s.placed.resize(character.mesh.vertices.size());
    s.in_world.resize(placing == Placing::all ? packed_.vertices(0).size() : character.mesh.vertices.size());
  }
}

void SkinningDetector::palette(const ScenarioFrame& frame) {
  const Pose* const poses[] = {&frame.first, &frame.second};
  const RigidTransform<double>* const placements[] = {&frame.first_at, &frame.second_at};
  for (int i = 0; i < 2; ++i) {
    palette_packs_.make(*poses[i], sides_[i].palette);
    sides_[i].placement = *placements[i];
    sides_[i].is_placed.begin();
  }
  candidates_.begin(frame.first_at.translation);
}

void SkinningDetector::skin() {
  for (Side& s : sides_) {
    if (placing_ == Placing::all) skin_and_place(s);
    else packed_.skin_all(s.palette, Skinning::spherical, s.skinned);
    counts_.vertices_skinned += static_cast<long>(s.skinned.size());
  }
}

void SkinningDetector::skin_and_place(Side& s) {
  packed_.skin_group(0, s.palette, Skinning::spherical, skinned_lanes_);
  const auto& [q, t] = s.placement;
  const double placement[] = {q[0], q[1], q[2], q[3], t[0], t[1], t[2]};
  const int blocks = static_cast<int>(s.in_world.size() / Lanes<double>::count);
  box_kernels(best_target()).place(skinned_lanes_.blocks.data(), blocks, placement, s.in_world.data());
  for (std::size_t v = 0; v < s.placed.size(); ++v) {
    const PaddedVertex& p = s.in_world[place_of_[v]];
    s.placed[v] = Point3(p.of[0], p.of[1], p.of[2]);
  }
}

const PaddedVertex& SkinningDetector::vertex_in_world(int side, int vertex) {
  Side& s = sides_[side];
  if (placing_ == Placing::all) return s.in_world[place_of_[vertex]];
  if (!s.is_placed.is_made(vertex)) {
    const Point3 p = apply(s.placement, s.skinned[vertex]);
    s.in_world[vertex] = {p[0], p[1], p[2], 0};
    s.is_placed.mark(vertex);
  }
  return s.in_world[vertex];
}

DetectorCounts SkinningDetector::counts() const {
  DetectorCounts out = counts_;
  out.triangle_tests = candidates_.count();
  return out;
}

}  // namespace refitlab
