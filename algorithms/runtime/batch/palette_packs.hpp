// SPDX-License-Identifier: MIT
// PalettePacks does make_skinning_palette in packs, eight joint-sets at a time, with the very same numbers.
#pragma once

#include "algorithms/runtime/batch/palette_kernel.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

class PalettePacks {
 public:
  // mesh and sets must outlive this. order lists all joint-sets. Those of the same number of joints that are near each other in
  // it share a part. If it is empty, the order is by index.
  PalettePacks(const SkinnedMesh& mesh, const JointSets& sets, Skinning skinning, std::span<const int> order = {});

  int set_count() const { return static_cast<int>(sources_.size()); }
  // Returns the number of joints of a joint-set, or 0 if it has more than a pack takes. Then it is a part of its own.
  int packed_joints(int joint_set) const { return sources_[joint_set].joint_count; }

  // Does what make_skinning_palette does, and throws the same errors. It overwrites palette and uses its storage again, but does
  // not measure it: call palette.measure() before refits of single nodes.
  void make(const Pose& pose, SkinningPalette<double>& palette, Target target = best_target()) const;

  // These make the palette part by part, on demand. Joint-sets whose palettes are made together have one part. arrays() gives
  // palette the size for all of them and returns its arrays. The pose must be as check_pose requires.
  int part_count() const { return static_cast<int>(parts_.size()); }
  int part_of(int joint_set) const { return part_of_[joint_set]; }
  std::span<const int> sets_of(int part) const { return parts_[part]; }
  SkinningPalette<double>::Arrays arrays(SkinningPalette<double>& palette) const { return palette.resize(first_slot_); }
  void make_part(int part, const Pose& pose, const SkinningPalette<double>::Arrays& out, Target target = best_target()) const;

  // Makes joint-sets for skinning in float, by spherical or Hejl's skinning: up to palette_lanes of the same packed_joints(), or
  // one of more joints, whose slack is infinite. out is by joint-set.
  void make_floats(std::span<const int> joint_sets, const Pose& pose, const FloatPlacement& at, FloatPaletteEntry* out,
                   Target target = best_target()) const;

 private:
  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const Skinning skinning_;
  std::vector<PaletteSource> sources_;   // by joint-set
  std::vector<std::vector<int>> parts_;  // their joint-sets
  std::vector<int> part_of_;             // by joint-set
  std::vector<std::size_t> first_slot_ = {0};
};

}  // namespace refitlab
