// PosePacks: make_skinning_pose in packs, eight joint-sets at a time, with the very same numbers.
#pragma once

#include "algorithms/batch/pose_kernel.hpp"
#include "algorithms/skinning/skinning_pose.hpp"

namespace refitlab {

class PosePacks {
 public:
  // model and sets outlive this.
  PosePacks(const Model& model, const JointSets& sets, Skinning skinning);

  // As make_skinning_pose, into pose, whose storage is used again. Throws the same. Not measured: if refits of single nodes
  // follow, pose.measure() must come first.
  void make(const Posture& posture, SkinningPose<double>& pose, Target target = best_target()) const;

 private:
  void add(int joint_set, std::size_t first_slot);

  const Model& model_;
  const JointSets& sets_;
  const Skinning skinning_;
  std::vector<PosePack> packs_[most_pose_joints];  // by number of joints - 1
  int lanes_[most_pose_joints] = {};
  std::vector<int> others_;  // joint-sets of more joints than a pack takes
  std::vector<std::size_t> first_slot_ = {0};
};

}  // namespace refitlab
