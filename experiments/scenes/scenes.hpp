// SPDX-License-Identifier: GPL-3.0-or-later
// The models and poses that every experiment shares are defined here once.
#pragma once

#include <string>
#include <vector>

#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/twist.hpp"

namespace refitlab {

// A PoseSet is one or more poses that are reported together: the sampled times of a clip, or a single pose.
struct PoseSet {
  std::string name;
  std::vector<Pose> poses;
  std::string kind = "clip";  // or that of a NamedPose
};

// DefaultModels are the two procedural models and the real ones found in a folder, by file name. absent names the real ones that
// are not there.
struct DefaultModels {
  std::vector<Model> models;
  std::vector<std::string> absent;
};
// Returns the model in a file, named as the file without its folder.
Model load_named(const std::string& path, const LoadOptions& options = {});
DefaultModels default_models(const std::string& folder);

// Returns every clip at this many times, evenly spread from start to end.
std::vector<PoseSet> pose_sets(const AnimatedCharacter& character, int times_per_clip);

struct NamedPose {
  std::string name;
  Pose pose;
  std::string kind = "twist";  // "twist": figure_twist; "worst_twist"
};
// Returns the pose of the paper's Figure 5. It is the end of the clip "twist" if the model has one, else a neck turned by 170
// degrees.
NamedPose figure_twist(const AnimatedCharacter& character);

}  // namespace refitlab
