// PosePacks: make_skinning_pose in packs, eight joint-sets at a time, with the very same numbers.
#pragma once

#include "algorithms/runtime/batch/pose_kernel.hpp"
#include "algorithms/runtime/skinning/skinning_pose.hpp"

namespace refitlab {

class PosePacks {
 public:
  // model and sets outlive this.
  PosePacks(const SkinnedMesh& mesh, const JointSets& sets, Skinning skinning);

  // As make_skinning_pose, into pose, whose storage is used again. Throws the same. Not measured: if refits of single nodes
  // follow, pose.measure() must come first.
  void make(const Posture& posture, SkinningPose<double>& pose, Target target = best_target()) const;

  // The same part by part, on demand: joint-sets whose pose is made together have one part. room gives pose the size
  // for all of them; the posture is as check_posture wants it.
  int part_count() const { return static_cast<int>(parts_.size()); }
  int part_of(int joint_set) const { return part_of_[joint_set]; }
  SkinningPose<double>::Arrays room(SkinningPose<double>& pose) const { return pose.resize(first_slot_); }
  void make_part(int part, const Posture& posture, const SkinningPose<double>::Arrays& out,
                 Target target = best_target()) const;

 private:
  struct Part {
    int joints, pack;  // or 0 and a joint-set of more joints than a pack takes
  };
  void add(int joint_set, std::size_t first_slot);

  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const Skinning skinning_;
  std::vector<PosePack> packs_[most_pose_joints];  // by number of joints - 1
  int lanes_[most_pose_joints] = {}, last_part_[most_pose_joints] = {};
  std::vector<Part> parts_;
  std::vector<int> part_of_;  // by joint-set
  std::vector<std::size_t> first_slot_ = {0};
};

}  // namespace refitlab
