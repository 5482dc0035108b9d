// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/animated_joints.hpp"

#include <algorithm>

namespace refitlab {

AnimatedJoints::AnimatedJoints(const Model& model, const Animation& animation, bool needs_pose)
    : model_(model),
      animation_(animation),
      needs_pose_(needs_pose) {
  if (model.skeleton.joints.size() != model.joints.size())
    throw ModelError(model.name, "clip '" + animation.name + "'", "it has no keys, and nothing is known of it between poses");
  const std::vector<SceneNode>& nodes = model.skeleton.nodes;
  times_ = smooth_times(model.name, nodes, animation);
  for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
    links_.push_back(link_motions(nodes, animation, times_[i], times_[i + 1]));
    chains_.push_back(chain_motions(nodes, links_.back()));
  }
  for (const double time : times_)
    if (jumps_at(animation, time)) jumps_.push_back(time);
}

Side AnimatedJoints::side_of(double time, Side side) const {
  return std::binary_search(jumps_.begin(), jumps_.end(), time) ? side : Side::after;
}

const PosedJoints& AnimatedJoints::at(double time, Side side) const {
  side = side_of(time, side);
  {
    const std::lock_guard lock(guard_);
    if (const auto found = posed_.find({time, side}); found != posed_.end()) return found->second;
  }
  PosedJoints posed{skin_matrices(model_.skeleton, animation_, time, side), {}, 0};
  if (needs_pose_) {
    posed.pose = pose(model_.skeleton, animation_, time, side).pose;
    for (std::size_t j = 0; j < posed.pose.size(); ++j) {
      const Quaternion<double>& q = posed.pose[j].rotation;
      const Eigen::Matrix3d rotation = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
      posed.defect = std::max(posed.defect, (posed.matrices[j].topLeftCorner<3, 3>() - rotation).norm());
    }
  }
  const std::lock_guard lock(guard_);
  return posed_.try_emplace({time, side}, std::move(posed)).first->second;
}

}  // namespace refitlab
