// SPDX-License-Identifier: MIT
// PackedVertices has groups of a model's vertices, laid out so that packs skin a group at a time, bit-identical to skin().
//
// Within a group vertices are sorted by joint-set; each run of one joint-set is padded to whole blocks of Lanes<double>, or to
// whole blocks of Lanes<float>, so that floats of the same vertices may have the same places (float_vertices.hpp).
#pragma once

#include "algorithms/runtime/batch/skin_kernel.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// Skinned vertices lie one place after the other, with three Lanes for each block of places. The padding holds copies of other
// places.
struct SkinnedVertices {
  Point3 operator[](int place) const {
    const Lanes<double>* block = blocks.data() + 3 * (place / Lanes<double>::count);
    const int lane = place % Lanes<double>::count;
    return {block[0].lane[lane], block[1].lane[lane], block[2].lane[lane]};
  }
  std::vector<Lanes<double>> blocks;  // x, y, z of a block of places, and so on
};

class PackedVertices {
 public:
  // A group is a list of distinct vertices, in any order; a vertex may be in several groups. Runs are padded to multiples of
  // padding, which is a multiple of Lanes<double>::count.
  PackedVertices(const SkinnedMesh& mesh, const JointSets& sets, std::span<const std::vector<int>> groups,
                 int padding = Lanes<double>::count);
  // Makes one group of all vertices.
  PackedVertices(const SkinnedMesh& mesh, const JointSets& sets);

  int group_count() const { return static_cast<int>(first_run_.size()) - 1; }
  // Returns the vertex at each place of a group. A padding place repeats the vertex before it.
  std::span<const int> vertices(int group) const;

  // Skins one group; out.blocks grows as needed and is used again. palette must come from make_skinning_palette for this model
  // with the same skinning, or have affine joints, which are blended linearly whatever the skinning. The same holds for skin_all.
  void skin_group(int group, const SkinningPalette<double>& palette, Skinning skinning, SkinnedVertices& out,
                  Target target = best_target()) const;

  // Skins a single block of a group. The result is its x, y and z.
  void skin_block(int group, int block, const SkinningPalette<double>& palette, Skinning skinning, Lanes<double>* out,
                  Target target = best_target()) const;

  // Skins all groups, each vertex to out[vertex]. out is as long as the model's vertices; the entries of vertices in no group
  // stay.
  void skin_all(const SkinningPalette<double>& palette, Skinning skinning, std::span<Point3> out,
                Target target = best_target()) const;

 private:
  struct Run {
    int joint_set, first_data, first_block, block_count;
  };

  void add_group(const SkinnedMesh& mesh, const JointSets& sets, std::vector<int> group, int padding);
  void skin_run(const Run& run, const SkinningPalette<double>& palette, SkinRun kernel, Lanes<double>* out) const;
  SkinRun kernel(bool is_affine, Skinning skinning, Target target) const;

  std::vector<int> first_run_ = {0};  // by group, and one past the last
  std::vector<Run> runs_;
  std::vector<Lanes<double>> data_;
  std::vector<int> vertices_;  // by place
};

}  // namespace refitlab
