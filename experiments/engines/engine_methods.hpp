// SPDX-License-Identifier: GPL-3.0-or-later
// The methods by which engines bound animated characters, and ours, have one interface. It goes from a pose to a box, or from a
// clip to one box for all of its poses. Methods are named after what they do.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/collide/motion_bound.hpp"
#include "experiments/engines/all_skinned.hpp"
#include "experiments/engines/joint_boxes.hpp"
#include "experiments/engines/joint_capsules.hpp"
#include "experiments/engines/padded_pivots.hpp"
#include "experiments/engines/rounded_boxes.hpp"

namespace refitlab {

// The joint boxes are the reference with which the others are compared.
inline constexpr std::size_t reference_method = 0;

// Returns poses of all clips, or of all but one, evenly spread from the first to the last of each.
std::vector<Pose> expected_poses(const Model& model, std::optional<std::size_t> left_out = {});

// JointVolumes are the volumes that joints carry. They are fitted once for all ways of skinning.
struct JointVolumes {
  // The volumes are fitted for the expected poses.
  explicit JointVolumes(const Model& model);

  JointBoxes boxes, pivots;
  JointCapsules capsules;
  RoundedBoxes rounded_boxes;
};

class PoseMethods {
 public:
  // All arguments must outlive this.
  PoseMethods(const Model& model, const JointSets& sets, const JointVolumes& volumes, Skinning skinning);

  // Returns the names of the methods.
  static const std::vector<std::string>& methods();
  // Returns the boxes of all methods in one pose. They are larger by a renderer's rounding, as bounds over time are. A box is
  // infinite if the method has no bound for the pose.
  std::vector<Box<double>> boxes(const Pose& pose);
  // Returns the box of a method, by position in methods(), without a renderer's rounding. This is what is timed.
  Box<double> box(std::size_t method, const Pose& pose);
  // Returns the true box.
  Box<double> truth(const Pose& pose) { return all_.box(pose, skinning_); }

 private:
  const Model& model_;
  const JointVolumes& volumes_;
  Skinning skinning_;
  JointMatrices matrices_;
  MotionBound motion_bound_;
  AllSkinned all_;
  double padding_;
};

// Returns the pose in which the file's nodes leave the joints. model has keys (with_keys).
Pose rest_pose(const Model& model);

// A PlayedClip is a clip as it is played.
struct PlayedClip {
  std::vector<double> key_times;  // 0 and the duration among them
  std::function<Pose(double)> sample;
};

struct ClipBox {
  std::string method;
  Box<double> box;  // with room for a renderer's rounding
};

// Returns the boxes of a clip:
// - that of the pose in which the file's nodes leave the joints, where the scene shows it. Filament culls a renderable by a box
//   that it was built with, which stays unless a program changes it;
// - that one made larger by hand, as until nothing seems to vanish: by 2;
// - those around sampled times (experiments/over_time/sampled_boxes.hpp). flutter_scene takes the keys;
// - that of joint boxes at fixed steps, which Babylon.js's computeMaxExtents merges. There, every vertex counts for each of its
//   bones, whatever its weight.
std::vector<ClipBox> clip_boxes(const Model& model, const PlayedClip& clip, PoseMethods& methods);
// Returns the methods of these boxes, in this order.
const std::vector<std::string>& clip_methods();

}  // namespace refitlab
