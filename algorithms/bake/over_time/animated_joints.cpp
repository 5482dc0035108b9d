// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/animated_joints.hpp"

#include <algorithm>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// This is enough for ten thousand poses of a hundred joints.
constexpr std::size_t bytes_of_poses = std::size_t(128) << 20;

}  // namespace

AnimatedJoints::AnimatedJoints(const Model& model, const Animation& animation, bool needs_pose)
    : model_(model),
      animation_(animation),
      needs_pose_(needs_pose),
      posed_(bytes_of_poses / (1 + model.skeleton.joints.size() * sizeof(Eigen::Matrix4d))) {
  const DefaultFloatEnvironment environment;
  if (model.skeleton.joints.size() != model.joints.size())
    throw ModelError(model.name, "clip '" + animation.name + "'", "it has no keys, and nothing is known of it between poses");
  const std::vector<SceneNode>& nodes = model.skeleton.nodes;
  times_ = part_times(model.name, nodes, animation);
  for (const MorphedMesh& mesh : model.morphs) weight_tracks_.push_back(weight_track_of(mesh, animation));
  for (const double time : times_)
    if (jumps_at(animation, time)) jumps_.push_back(time);
  for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
    auto motions = std::make_shared<JointMotions>();
    for (std::size_t m = 0; m < model.morphs.size(); ++m)
      motions->weights.push_back(weight_motions(model.morphs[m], weight_tracks_[m], times_[i], times_[i + 1]));
    motions->links = link_motions(nodes, animation, times_[i], times_[i + 1]);
    motions->chains = chain_motions(nodes, motions->links);
    motions_.push_back(std::move(motions));
    roundings_.push_back(growth_of_rounding(animation, times_[i], times_[i + 1]));
    defects_.push_back(needs_pose ? defect_of(model.skeleton, stretches(nodes, animation, times_[i], times_[i + 1])) : 0);
  }
}

std::vector<ParameterBox> AnimatedJoints::boxes() const {
  std::vector<ParameterBox> out;
  for (int part = 0; part < part_count(); ++part) out.push_back({{{part, part, times_[part], times_[part + 1]}}});
  return out;
}

JointCell AnimatedJoints::cell(int part, double start, double end) const { return cell({{{part, part, start, end}}}); }

JointCell AnimatedJoints::cell(const ParameterBox& box) const {
  const ParameterRange& range = box.ranges[0];
  const int part = range.first_part;
  JointCell out{this, {range.end - range.start}, {motions_[part]}, corners_of(box), defects_[part], roundings_[part]};
  for (ParameterMoment& corner : out.corners) {
    auto& [value, side] = corner.coordinates[0];
    side = side_of(value, side);
  }
  return out;
}

std::vector<ParameterBox> AnimatedJoints::halves(const ParameterBox& box, std::size_t, bool) const {
  const ParameterRange& range = box.ranges[0];
  const double middle = range.start + (range.end - range.start) / 2;
  if (!(range.start < middle && middle < range.end)) return {};
  return {{{{range.first_part, range.last_part, range.start, middle}}},
          {{{range.first_part, range.last_part, middle, range.end}}}};
}

Side AnimatedJoints::side_of(double time, Side side) const {
  return std::binary_search(jumps_.begin(), jumps_.end(), time) ? side : Side::after;
}

std::shared_ptr<const PosedJoints> AnimatedJoints::at(const ParameterMoment& moment) const {
  return at(moment.coordinates[0].value, moment.coordinates[0].side);
}

std::shared_ptr<const PosedJoints> AnimatedJoints::at(double time, Side side) const {
  const DefaultFloatEnvironment environment;
  side = side_of(time, side);
  return posed_.get({time, side}, [&] { return posed(time, side); });
}

PosedJoints AnimatedJoints::posed(double time, Side side) const {
  PosedJoints posed{skin_matrices(model_.skeleton, animation_, time, side), {}, {}};
  for (std::size_t m = 0; m < weight_tracks_.size(); ++m)
    posed.weights.push_back(weights_at(model_.morphs[m], weight_tracks_[m], time, side));
  check_finite(*this, posed, std::to_string(time) + " s");
  if (needs_pose_) posed.pose = pose(model_.skeleton, animation_, time, side).pose;
  return posed;
}

}  // namespace refitlab
