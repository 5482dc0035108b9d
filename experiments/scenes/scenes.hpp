// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes: the models and poses that every experiment shares, defined once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/bake/bake.hpp"
#include "experiments/scenes/twist.hpp"

namespace refitlab {

// One or more poses that are reported together: the sampled times of a clip, or a single one.
struct PoseSet {
  std::string name;
  std::vector<Pose> poses;
  std::string kind = "clip";  // or that of a NamedPose
};

// The two procedural models and the real ones found in folder, by file name; absent: the real ones that are not there.
struct DefaultModels {
  std::vector<Model> models;
  std::vector<std::string> absent;
};
// The model in a file, named as the file without its folder.
Model load_named(const std::string& path, const LoadOptions& options = {});
DefaultModels default_models(const std::string& folder);

// Every clip at this many times, evenly spread from start to end.
std::vector<PoseSet> pose_sets(const AnimatedCharacter& character, int times_per_clip);

struct NamedPose {
  std::string name;
  Pose pose;
  std::string kind = "twist";  // "twist": figure_twist; "worst_twist"
};
// The pose of the paper's Figure 5: the end of the clip "twist" if the model has one, else a neck turned by 170 degrees.
NamedPose figure_twist(const AnimatedCharacter& character);

}  // namespace refitlab
