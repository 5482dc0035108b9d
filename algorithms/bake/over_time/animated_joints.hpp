// SPDX-License-Identifier: GPL-3.0-or-later
// The joints of a model in an animation: where they are at a time, and how they move between two times.
#pragma once

#include <map>
#include <mutex>

#include "algorithms/bake/over_time/node_motions.hpp"
#include "algorithms/model/model.hpp"

namespace refitlab {

// What skins the vertices at a moment, by joint.
struct PosedJoints {
  std::vector<Eigen::Matrix4d> matrices;  // the skin matrices; on columns, from the reference pose
  Pose pose;                              // the rigid transforms nearest to them; empty where they are not asked for
  std::vector<Eigen::VectorXd> weights;   // by target, for each of the morphed meshes of the model
};

// The side of an interval's end that belongs to it: of a moment, the later one, which the animation shows then.
inline Side side_of_end(double start, double end) { return start < end ? Side::before : Side::after; }

class AnimatedJoints {
 public:
  // model outlives this. needs_pose: spherical and dual quaternion skinning do. Throws ModelError for a model without a skeleton
  // of keys, and for splines that smooth_times refuses.
  AnimatedJoints(const Model& model, const Animation& animation, bool needs_pose);

  const Model& model() const { return model_; }
  // Seconds; every part from one to the next is smooth. The last part is a moment where the animation has no duration, or jumps
  // at its end: then it ends with what comes after the jump.
  const std::vector<double>& times() const { return times_; }
  int part_count() const { return static_cast<int>(links_.size()); }
  // By node, over a part; against the parent and against the scene.
  const std::vector<ChainMotion<double>>& links(int part) const { return links_[part]; }
  const std::vector<ChainMotion<double>>& chains(int part) const { return chains_[part]; }
  // By target, for each of the model's morphed meshes, over a part.
  const std::vector<std::vector<Motion<double>>>& weights(int part) const { return weights_[part]; }

  // How far the linear part of a joint's skin matrix is from the rotation that its chain's quaternions make, at any time of a part,
  // at most: by the noise of scales that should be one. Infinite where a scale may vanish; 0 where no poses are asked for.
  double defect(int part) const { return defects_[part]; }
  // growth_of_rounding.
  double rounding(int part) const { return roundings_[part]; }

  // Side::after where both sides of a time are the same.
  Side side_of(double time, Side side) const;

  // At a time of the animation. What is returned stays. May be called by several threads. Throws ModelError for a pose that
  // is asked for and is not rigid.
  const PosedJoints& at(double time, Side side) const;

 private:
  const Model& model_;
  const Animation& animation_;
  bool needs_pose_;
  std::vector<double> times_, jumps_;  // in increasing order
  std::vector<std::vector<ChainMotion<double>>> links_, chains_;
  std::vector<const WeightTrack*> weight_tracks_;  // by morphed mesh; nullptr where weights stay
  std::vector<std::vector<std::vector<Motion<double>>>> weights_;
  std::vector<double> defects_, roundings_;
  mutable std::mutex guard_;
  mutable std::map<std::pair<double, Side>, PosedJoints> posed_;
};

}  // namespace refitlab
