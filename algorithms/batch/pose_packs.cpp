#include "algorithms/batch/pose_packs.hpp"

#include <algorithm>

#include "algorithms/skinning/rotation_center.hpp"

namespace refitlab {

PosePacks::PosePacks(const Model& model, const JointSets& sets, Skinning skinning)
    : model_(model), sets_(sets), skinning_(skinning) {
  for (int s = 0; s < sets.count(); ++s) {
    const std::size_t joints = sets.joints(s).size();
    if (joints > most_pose_joints) others_.push_back(s);
    else add(s, first_slot_.back());
    first_slot_.push_back(first_slot_.back() + joints);
  }
}

void PosePacks::add(int joint_set, std::size_t first_slot) {
  const auto joints = sets_.joints(joint_set);
  auto& packs = packs_[joints.size() - 1];
  int& lane = lanes_[joints.size() - 1];
  if (lane == 0) packs.emplace_back();
  const Point3 prior = center_prior(model_, joints, skinning_);
  for (int to = lane; to < pose_lanes; ++to) {  // the lanes behind are overwritten by the joint-sets to come
    for (int i = 0; i < 3; ++i) packs.back().prior[i][to] = prior[i];
    for (std::size_t j = 0; j < joints.size(); ++j) packs.back().joint[j][to] = joints[j];
    packs.back().set[to] = joint_set;
    packs.back().first_slot[to] = static_cast<std::int32_t>(first_slot);
  }
  lane = (lane + 1) % pose_lanes;
}

void PosePacks::make(const Posture& posture, SkinningPose<double>& pose, Target target) const {
  static_assert(sizeof(RigidTransform<double>) == 8 * sizeof(double));
  check_posture(model_, posture);
  const auto out = pose.resize(first_slot_);
  const PoseNumbers numbers{out.rotation_centers->data(), out.transforms->rotation.data(), out.center_images->data(),
                            out.duals->data()};
  const PoseRun run = pose_run(target);
  for (int n = 0; n < most_pose_joints; ++n)
    run(packs_[n].data(), static_cast<int>(packs_[n].size()), n + 1, skinning_ == Skinning::hejl,
        posture[0].rotation.data(), numbers);
  for (const int s : others_) {
    const auto joints = sets_.joints(s);
    OwnedJointSetPose<double> set;
    for (const int j : joints) set.transforms.push_back(posture[j]);
    make_signs_consistent<double>(set.transforms);
    const Point3 prior = center_prior(model_, joints, skinning_);
    place_rotation_center(set, skinning_ == Skinning::hejl ? prior : rotation_center<double>(set.transforms, prior));
    place_duals(set);
    out.rotation_centers[s] = set.rotation_center;
    std::copy(set.transforms.begin(), set.transforms.end(), out.transforms + first_slot_[s]);
    std::copy(set.center_images.begin(), set.center_images.end(), out.center_images + first_slot_[s]);
    std::copy(set.duals.begin(), set.duals.end(), out.duals + first_slot_[s]);
  }
}

}  // namespace refitlab
