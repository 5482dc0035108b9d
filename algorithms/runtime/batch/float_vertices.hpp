// SPDX-License-Identifier: MIT
// FloatVertices has the groups of PackedVertices once more, laid out for skinning in float. The vertices of a group have positions:
// they are numbered in the order of their places in PackedVertices, without the padding.
#pragma once

#include <cstdint>

#include "algorithms/runtime/batch/float_skin_kernel.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"

namespace refitlab {

class FloatVertices {
 public:
  // The groups' runs are padded to whole blocks of Lanes<float>, and no group has more than 2^16 places.
  FloatVertices(const SkinnedMesh& mesh, const JointSets& sets, const PackedVertices& groups);

  // Returns the joint-sets of a group. Each appears once.
  std::span<const FloatRun> runs(int group) const {
    return std::span(runs_).subspan(first_run_[group], first_run_[group + 1] - first_run_[group]);
  }
  // Returns how many blocks of vertices are skinned for a group, with the padding of its runs.
  int block_count(int group) const { return block_count_[group]; }
  // Returns the places of a group's vertices in PackedVertices, by position.
  std::span<const std::uint16_t> places(int group) const {
    return std::span(places_).subspan(first_place_[group], first_place_[group + 1] - first_place_[group]);
  }
  // Returns how much room a coordinate of a group takes, in whole blocks: its vertices, and what skinning writes behind them.
  int room(int group) const { return room_[group]; }

  // Skins a group to out, which gets the x of its vertices by position, then y, then z, room(group) apart. palette is by joint-set,
  // made for its runs by PalettePacks::make_floats, with finite slacks. box becomes the box around the result. Returns the largest of
  // the slacks.
  float skin(int group, const FloatPaletteEntry* palette, float* out, Box<float>& box, Target target = best_target()) const;

 private:
  std::vector<int> first_run_ = {0}, first_place_ = {0}, block_count_, room_;  // by group
  std::vector<FloatRun> runs_;
  std::vector<std::uint16_t> places_;
  std::vector<Lanes<float>> data_;
};

}  // namespace refitlab
