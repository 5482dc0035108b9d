// SPDX-License-Identifier: GPL-3.0-or-later
// CrossfadedJoints are the joints of a model while one animation fades to another, at any time of either and with any weight in
// [0, 1].
//
// Nodes are blended against their parents, as engines do: translations, scales and morph weights linearly, rotations by slerp or
// by nlerp on the shorter way (c7_crossfade). A node that one of the animations does not move rests in it.
#pragma once

#include <span>

#include "algorithms/bake/over_time/bounded_cache.hpp"
#include "algorithms/bake/over_time/moving_joints.hpp"
#include "algorithms/bake/over_time/node_motions.hpp"
#include "algorithms/runtime/skinning/rotation_blend.hpp"
#include "lemmas/c4_chain_motion.hpp"

namespace refitlab {

// A FadingClip is one of both animations. It has a track for each node that either animation moves and that is above some joint.
class FadingClip {
 public:
  // Throws ModelError for a node that only the other animation moves and whose matrix has no parts, and what part_times throws.
  FadingClip(const Model& model, const Animation& animation, const Animation& other, std::span<const int> joints,
             bool needs_stretches);

  // These motions bound all parts from the first to the last of a range.
  struct Motions {
    std::vector<LinkMotion<double>> tracks;            // by track
    std::vector<std::vector<Motion<double>>> weights;  // by target, for each of the model's morphed meshes
    std::vector<Stretch> stretches;                    // by node; none unless needed
    double rounding;                                   // growth_of_rounding
  };
  // Returns the motions of these parts. For several parts accelerations are infinite, and so are speeds if there is a jump
  // between them.
  std::shared_ptr<const Motions> motions(int first_part, int last_part) const;

  const std::string& name() const { return animation_.name; }
  const std::vector<NodeTrack>& tracks() const { return animation_.tracks; }  // by increasing node
  // Returns the weights of a mesh's morph targets.
  Eigen::VectorXd weights(std::size_t mesh, double time, Side side) const;

  // Returns the range from the first time to the last.
  ParameterRange whole() const;
  std::vector<ParameterRange> halves(const ParameterRange& range) const;
  Side side_of(double time, Side side) const;

 private:
  Motions of_part(int part) const;
  Motions of_parts(int first, int last) const;

  const Model& model_;
  Animation animation_;
  bool needs_stretches_;
  std::vector<double> times_, jumps_;
  std::vector<const WeightTrack*> weight_tracks_;  // by morphed mesh; nullptr where weights stay
  mutable BoundedCache<std::pair<int, int>, Motions> known_;
};

class CrossfadedJoints : public MovingJoints {
 public:
  // model must outlive this. joints are those of the model that count; the nodes of others rest. needs_pose is true for spherical
  // and dual quaternion skinning. Throws ModelError for a model without a skeleton of keys, and what FadingClip throws.
  CrossfadedJoints(const Model& model, const Animation& first, const Animation& second, std::span<const int> joints,
                   RotationBlend rotations, bool needs_pose);

  const Model& model() const override { return model_; }
  std::string name() const override { return "crossfade of '" + first_.name() + "' and '" + second_.name() + "'"; }
  // The parameters are the time of the first animation, that of the second, and the weight of the second.
  std::vector<ParameterBox> boxes() const override;
  JointCell cell(const ParameterBox& box) const override;
  std::vector<ParameterBox> halves(const ParameterBox& box, std::size_t parameter, bool is_known) const override;
  std::shared_ptr<const PosedJoints> at(const ParameterMoment& moment) const override;

 private:
  // A KnownCell is a cell, and the first node of which it is not known which of both quaternions is nearer, because both are
  // about a right angle away.
  struct KnownCell {
    JointCell cell;
    std::optional<int> across;
  };
  std::shared_ptr<const KnownCell> known(const ParameterBox& box) const;
  KnownCell make(const ParameterBox& box) const;
  PosedJoints posed(const ParameterMoment& moment) const;

  const Model& model_;
  RotationBlend rotations_;
  bool needs_pose_;
  FadingClip first_, second_;
  mutable BoundedCache<ParameterBox, KnownCell> cells_;
  mutable BoundedCache<ParameterMoment, PosedJoints> posed_;
};

}  // namespace refitlab
