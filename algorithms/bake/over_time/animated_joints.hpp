// SPDX-License-Identifier: GPL-3.0-or-later
// AnimatedJoints are the joints of a model in an animation. They tell where the joints are at a time, and how they move between
// two times.
#pragma once

#include "algorithms/bake/over_time/bounded_cache.hpp"
#include "algorithms/bake/over_time/moving_joints.hpp"
#include "algorithms/bake/over_time/node_motions.hpp"

namespace refitlab {

class AnimatedJoints : public MovingJoints {
 public:
  // model and animation must outlive this. needs_pose is true for spherical and dual quaternion skinning. Throws ModelError for a
  // model without a skeleton of keys, and for splines that smooth_times refuses.
  AnimatedJoints(const Model& model, const Animation& animation, bool needs_pose);

  const Model& model() const override { return model_; }
  // Clips have names; an animation that has none is the rest pose.
  std::string name() const override { return animation_.name.empty() ? "rest pose" : "clip '" + animation_.name + "'"; }
  // Returns the times, in seconds, between which every part is smooth. If the animation has no duration, or jumps at its end, the
  // last part is a moment. It then has what comes after the jump.
  const std::vector<double>& times() const { return times_; }
  int part_count() const { return static_cast<int>(motions_.size()); }
  const JointMotions& motions(int part) const { return *motions_[part]; }

  // Returns a box for each part.
  std::vector<ParameterBox> boxes() const override;
  // Returns the cell from start to end, which are times in this part.
  JointCell cell(int part, double start, double end) const;
  JointCell cell(const ParameterBox& box) const override;
  std::vector<ParameterBox> halves(const ParameterBox& box, std::size_t parameter, bool is_known) const override;

  // Returns the side, or Side::after if both sides of the time are the same.
  Side side_of(double time, Side side) const;
  // Returns the posed joints at a time. Those of many times are shared by all who ask for the same.
  std::shared_ptr<const PosedJoints> at(double time, Side side) const;
  std::shared_ptr<const PosedJoints> at(const ParameterMoment& moment) const override;

 private:
  PosedJoints posed(double time, Side side) const;

  const Model& model_;
  const Animation& animation_;
  bool needs_pose_;
  std::vector<double> times_, jumps_;                         // in increasing order
  std::vector<std::shared_ptr<const JointMotions>> motions_;  // by part
  std::vector<const WeightTrack*> weight_tracks_;             // by morphed mesh; nullptr where weights stay
  std::vector<double> defects_, roundings_;                   // by part
  mutable BoundedCache<std::pair<double, Side>, PosedJoints> posed_;
};

}  // namespace refitlab
