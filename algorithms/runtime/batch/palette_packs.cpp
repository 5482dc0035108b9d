// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/palette_packs.hpp"

#include <algorithm>
#include <limits>

#include "algorithms/runtime/batch/joint_set_balls.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace refitlab {

PalettePacks::PalettePacks(const SkinnedMesh& mesh, const JointSets& sets, Skinning skinning, std::span<const int> order)
    : mesh_(mesh),
      sets_(sets),
      skinning_(skinning),
      part_of_(sets.count()) {
  const auto balls = joint_set_balls(mesh, sets);
  for (int s = 0; s < sets.count(); ++s) first_slot_.push_back(first_slot_.back() + sets.joints(s).size());
  for (int i = 0; i < sets.count(); ++i) {
    const int s = order.empty() ? i : order[i];
    if (sets.joints(s).size() > most_palette_joints) part_of_[s] = part_count(), parts_.push_back({0, s});
    else add(s, balls[s]);
  }
}

void PalettePacks::add(int joint_set, const Ball3<double>& ball) {
  const DefaultFloatEnvironment environment;
  const auto joints = sets_.joints(joint_set);
  auto& packs = packs_[joints.size() - 1];
  int& lane = lanes_[joints.size() - 1];
  if (lane == 0) {
    parts_.push_back({static_cast<int>(joints.size()), static_cast<int>(packs.size())});
    last_part_[joints.size() - 1] = part_count() - 1;
    packs.emplace_back();
  }
  part_of_[joint_set] = last_part_[joints.size() - 1];
  const Point3 prior = center_prior(mesh_, joints, skinning_);
  for (int to = lane; to < palette_lanes; ++to) {  // the lanes behind are overwritten by the joint-sets to come
    for (int i = 0; i < 3; ++i) packs.back().prior[i][to] = prior[i], packs.back().middle[i][to] = ball.center[i];
    packs.back().radius[to] = ball.radius;
    for (std::size_t j = 0; j < joints.size(); ++j) packs.back().joint[j][to] = joints[j];
    packs.back().set[to] = joint_set;
    packs.back().first_slot[to] = static_cast<std::int32_t>(first_slot_[joint_set]);
  }
  lane = (lane + 1) % palette_lanes;
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
  const auto [joint_count, at] = parts_[part];
  if (joint_count > 0) {
    palette_kernels(target).run(
        &packs_[joint_count - 1][at], 1, joint_count, skinning_ == Skinning::hejl, pose[0].rotation.data(),
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

void PalettePacks::make_float_part(int part, const Pose& pose, const FloatPlacement& at, FloatPaletteEntry* out,
                                   Target target) const {
  const DefaultFloatEnvironment environment;
  const auto [joint_count, place] = parts_[part];
  if (joint_count > 0)
    palette_kernels(target).run_float(&packs_[joint_count - 1][place], 1, joint_count, skinning_ == Skinning::hejl,
                                      pose[0].rotation.data(), at, out);
  else out[place].slack = std::numeric_limits<float>::infinity();
}

}  // namespace refitlab
