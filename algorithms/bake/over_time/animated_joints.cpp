// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/animated_joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Each link is a factor times a rotation times I + E, with ||E|| at most its noise. The rotations' product differs from the whole
// by what the noises add up to, and by how far the factors' product is from 1.
double defect_of(const BoundSkeleton& skeleton, const std::vector<Stretch>& links, const BoundJoint& joint) {
  double factor = 1, noise = 1;
  const auto add = [&](const Stretch& link) {
    factor *= std::sqrt(link.least * link.most);
    noise *= std::sqrt(link.most / link.least);
  };
  add(stretch_of(joint.offset));
  for (int n = joint.node; n >= 0; n = skeleton.nodes[n].parent) add(links[n]);
  const double defect = factor * (noise - 1) + std::abs(factor - 1);
  return defect >= 0 ? defect : std::numeric_limits<double>::infinity();
}

}  // namespace

AnimatedJoints::AnimatedJoints(const Model& model, const Animation& animation, bool needs_pose)
    : model_(model),
      animation_(animation),
      needs_pose_(needs_pose) {
  const DefaultFloatEnvironment environment;
  if (model.skeleton.joints.size() != model.joints.size())
    throw ModelError(model.name, "clip '" + animation.name + "'", "it has no keys, and nothing is known of it between poses");
  const std::vector<SceneNode>& nodes = model.skeleton.nodes;
  times_ = smooth_times(model.name, nodes, animation);
  for (const MorphedMesh& mesh : model.morphs) {
    const auto found = std::find_if(animation.weight_tracks.begin(), animation.weight_tracks.end(),
                                    [&](const WeightTrack& track) { return track.node == mesh.node; });
    weight_tracks_.push_back(found == animation.weight_tracks.end() ? nullptr : &*found);
  }
  for (const double time : times_)
    if (jumps_at(animation, time)) jumps_.push_back(time);
  if (const double end = times_.back(); times_.size() == 1 || jumps_at(animation, end)) times_.push_back(end);
  for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
    auto& weights = weights_.emplace_back();
    for (std::size_t m = 0; m < model.morphs.size(); ++m) {
      if (weight_tracks_[m]) weights.push_back(weight_motions(*weight_tracks_[m], times_[i], times_[i + 1]));
      else {
        auto& at_rest_ones = weights.emplace_back();
        for (const double w : model.morphs[m].weights) at_rest_ones.push_back(at_rest(std::abs(w)));
      }
    }
    links_.push_back(link_motions(nodes, animation, times_[i], times_[i + 1]));
    chains_.push_back(chain_motions(nodes, links_.back()));
    roundings_.push_back(growth_of_rounding(animation, times_[i], times_[i + 1]));
    defects_.push_back(0);
    if (!needs_pose) continue;
    const auto stretched = stretches(nodes, animation, times_[i], times_[i + 1]);
    for (const BoundJoint& joint : model.skeleton.joints)
      defects_.back() = std::max(defects_.back(), defect_of(model.skeleton, stretched, joint));
  }
}

Side AnimatedJoints::side_of(double time, Side side) const {
  return std::binary_search(jumps_.begin(), jumps_.end(), time) ? side : Side::after;
}

const PosedJoints& AnimatedJoints::at(double time, Side side) const {
  const DefaultFloatEnvironment environment;
  side = side_of(time, side);
  {
    const std::lock_guard lock(guard_);
    if (const auto found = posed_.find({time, side}); found != posed_.end()) return found->second;
  }
  PosedJoints posed{skin_matrices(model_.skeleton, animation_, time, side), {}, {}};
  for (std::size_t m = 0; m < weight_tracks_.size(); ++m) {
    const std::vector<double>& still = model_.morphs[m].weights;
    posed.weights.push_back(weight_tracks_[m] ? weights_at(*weight_tracks_[m], time, side)
                                              : Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
                                                    still.data(), static_cast<Eigen::Index>(still.size()))));
  }
  if (needs_pose_) posed.pose = pose(model_.skeleton, animation_, time, side).pose;
  const std::lock_guard lock(guard_);
  return posed_.try_emplace({time, side}, std::move(posed)).first->second;
}

}  // namespace refitlab
