// SPDX-License-Identifier: MIT
// FloatVertices has the groups of PackedVertices once more, at the same places, laid out for skinning in float.
#pragma once

#include "algorithms/runtime/batch/float_skin_kernel.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"

namespace refitlab {

class FloatVertices {
 public:
  // The groups' runs are padded to whole blocks of Lanes<float>.
  FloatVertices(const SkinnedMesh& mesh, const JointSets& sets, const PackedVertices& groups);

  // Returns the joint-sets of a group. Each appears once.
  std::span<const FloatRun> runs(int group) const {
    return std::span(runs_).subspan(first_run_[group], first_run_[group + 1] - first_run_[group]);
  }
  int block_count(int group) const { return block_count_[group]; }

  // Skins a group to out, which gets the x of all its blocks, then y, then z. palette is by joint-set, made for its runs by
  // PalettePacks::make_floats, with finite slacks. box becomes the box around the result. Returns the largest of the slacks.
  float skin(int group, const FloatPaletteEntry* palette, Lanes<float>* out, Box<float>& box,
             Target target = best_target()) const;

 private:
  std::vector<int> first_run_ = {0}, block_count_;  // by group
  std::vector<FloatRun> runs_;
  std::vector<Lanes<float>> data_;
};

}  // namespace refitlab
