// SPDX-License-Identifier: MIT
// PoseChange makes a box around a skinned character sooner than MotionBound does, from how far its joints are from where they were in
// an earlier pose. The box is larger, and the more so the more has changed.
//
// By b9_pose_change, if no joint has carried the points f of its groups farther than d, and no quaternion is farther than e from that
// of the earlier pose, vertices are within d + s(1 - 2 e) A + s(c - 2 e) n d of the earlier bound, or, where c - 2 e is small, within
// d + s(c - 2 e) (A + n d). Here c is the least of all groups, and n and A are the greatest. A placement that turns
// by Q' rather than Q carries what is at most N from the model's origin no farther than 2 ||Q' - Q|| N, and what it moves by is the
// same for all. So one pass over the joints is enough, without groups and their joints.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/runtime/collide/motion_bound.hpp"

namespace refitlab {

class PoseChange {
 public:
  // bound, or a copy of it, must outlive this.
  explicit PoseChange(const MotionBound& bound);

  // Starts anew from a pose and a placement, for which bound has just made a box. It may be any copy of that of the constructor.
  void start(const MotionBound& bound, const Pose& pose, const RigidTransform<double>& placement);

  // Returns a box in the world around everything that apply(placement, skin()) yields. It returns nothing if no pose is kept, if no
  // bound is known by it, and for a pose that check_pose would perhaps refuse. placement must be rigid.
  std::optional<Box<double>> box(const Pose& pose, const RigidTransform<double>& placement, Target target = best_target());

  // Says that the last box was too large to be of use. If the one before was that of start(), some of the next starts keep nothing,
  // because poses change too much, or bodies are too near, for that to pay.
  void give_up();

 private:
  static constexpr int rests_after_failure = 8;

  bool is_started_ = false, deviates_;
  int boxes_ = 0, rests_ = 0, most_joints_;
  const JointAnchors* anchors_;
  std::vector<Lanes<float>> kept_;
  Quaternion<double> rotation_{};  // of the placement
  MotionBound::Posed posed_{};
};

}  // namespace refitlab
