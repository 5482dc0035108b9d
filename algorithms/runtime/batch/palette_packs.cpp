// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/palette_packs.hpp"

#include <algorithm>
#include <limits>

#include "algorithms/runtime/batch/joint_set_balls.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace refitlab {
namespace {

// Returns the pack of at most palette_lanes joint-sets.
PalettePack pack_of(std::span<const int> joint_sets) {
  PalettePack out{{}, static_cast<int>(joint_sets.size())};
  for (std::size_t lane = 0; lane < palette_lanes; ++lane) out.set[lane] = joint_sets[std::min(lane, joint_sets.size() - 1)];
  return out;
}

}  // namespace

PalettePacks::PalettePacks(const SkinnedMesh& mesh, const JointSets& sets, Skinning skinning, std::span<const int> order)
    : mesh_(mesh),
      sets_(sets),
      skinning_(skinning),
      part_of_(sets.count()) {
  const DefaultFloatEnvironment environment;
  const auto balls = joint_set_balls(mesh, sets);
  int last_part[most_palette_joints + 1];  // by number of joints
  std::fill(std::begin(last_part), std::end(last_part), -1);
  for (int s = 0; s < sets.count(); ++s) {
    const auto joints = sets.joints(s);
    PaletteSource& source = sources_.emplace_back();
    const Point3 prior = center_prior(mesh, joints, skinning);
    for (int i = 0; i < 3; ++i) source.numbers[i] = prior[i], source.numbers[3 + i] = balls[s].center[i];
    source.numbers[6] = balls[s].radius;
    if (joints.size() <= most_palette_joints) {
      source.joint_count = static_cast<std::int32_t>(joints.size());
      std::copy(joints.begin(), joints.end(), source.joint);
    }
    source.first_slot = static_cast<std::int32_t>(first_slot_.back());
    first_slot_.push_back(first_slot_.back() + joints.size());
  }
  for (int i = 0; i < sets.count(); ++i) {
    const int s = order.empty() ? i : order[i];
    int& last = last_part[packed_joints(s)];
    if (last < 0 || packed_joints(s) == 0 || parts_[last].size() == palette_lanes) last = part_count(), parts_.emplace_back();
    parts_[last].push_back(s);
    part_of_[s] = last;
  }
}

void PalettePacks::make(const Pose& pose, SkinningPalette<double>& palette, Target target) const {
  const DefaultFloatEnvironment environment;
  check_pose(mesh_, pose);
  const auto out = arrays(palette);
  for (int part = 0; part < part_count(); ++part) make_part(part, pose, out, target);
}

void PalettePacks::make_part(int part, const Pose& pose, const SkinningPalette<double>::Arrays& out, Target target) const {
  const DefaultFloatEnvironment environment;
  static_assert(sizeof(RigidTransform<double>) == 8 * sizeof(double));
  const int at = parts_[part][0];
  if (const int joint_count = packed_joints(at); joint_count > 0) {
    palette_kernels(target).run(
        sources_.data(), pack_of(parts_[part]), joint_count, skinning_ == Skinning::hejl, pose[0].rotation.data(),
        {out.rotation_centers->data(), out.transforms->rotation.data(), out.center_images->data(), out.duals->data()});
    return;
  }
  const auto joints = sets_.joints(at);
  OwnedPaletteEntry<double> set;
  for (const int j : joints) set.transforms.push_back(pose[j]);
  make_signs_consistent<double>(set.transforms);
  const Point3 prior = center_prior(mesh_, joints, skinning_);
  place_rotation_center(set, skinning_ == Skinning::hejl ? prior : rotation_center<double>(set.transforms, prior));
  place_duals(set);
  out.rotation_centers[at] = set.rotation_center;
  std::copy(set.transforms.begin(), set.transforms.end(), out.transforms + first_slot_[at]);
  std::copy(set.center_images.begin(), set.center_images.end(), out.center_images + first_slot_[at]);
  std::copy(set.duals.begin(), set.duals.end(), out.duals + first_slot_[at]);
}

void PalettePacks::make_floats(std::span<const int> joint_sets, const Pose& pose, const FloatPlacement& at,
                               FloatPaletteEntry* out, Target target) const {
  const DefaultFloatEnvironment environment;
  if (const int joint_count = packed_joints(joint_sets[0]); joint_count > 0)
    palette_kernels(target).run_float(sources_.data(), pack_of(joint_sets), joint_count, skinning_ == Skinning::hejl,
                                      pose[0].rotation.data(), at, out);
  else out[joint_sets[0]].slack = std::numeric_limits<float>::infinity();
}

}  // namespace refitlab
