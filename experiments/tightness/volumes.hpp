// SPDX-License-Identifier: GPL-3.0-or-later
// The volumes experiment measures how tight refitted boxes, k-DOPs and oriented boxes are, how large they are beside the refitted
// balls, and what they cost.
//
// The size of a volume is the radius of the ball of the same surface area, sqrt(area / 4 pi). By Cauchy's theorem the shadows of
// that ball are as large on average. The size is a length, is the radius for a ball, and is not 0 for a flat volume.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"
#include "experiments/speed/timing.hpp"
#include "experiments/tightness/levels.hpp"

namespace refitlab {

struct VolumeResult {
  std::string model, pose, pose_kind;
  int poses;                                                 // how many were sampled
  std::map<std::string, std::vector<LevelVolumes>> volumes;  // by variant, by level - 1
};

// A VolumeCost is the cost of refitting a node to a variant's volume, on average over all nodes of the tree.
struct VolumeCost {
  std::string model, pose, pose_kind, variant;
  double ns_per_node;    // median over the repetitions
  double ratio_to_ball;  // the same of the ratio to the default balls of the skinning, which are in the list too
};

struct VolumeSettings {
  int times_per_clip = 8;
  int nodes_per_level = 64;  // at most, evenly spread
  SpeedSettings speed = {.seconds_per_run = 0.05, .repetitions = 5};
};

struct VolumeResults {
  std::vector<VolumeResult> tightness;
  std::vector<VolumeCost> costs;
};

// Measures all clips and the pose of one model, and appends to results. Progress and tables go to stdout.
void run_volumes(const AnimatedCharacter& character, const NamedPose& pose, const VolumeSettings& settings,
                 VolumeResults& results);

// Writes all results as out/results/volumes.csv.
void write_volumes(const VolumeResults& results, const std::string& path);

}  // namespace refitlab
