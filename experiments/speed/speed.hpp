// SPDX-License-Identifier: GPL-3.0-or-later
// The speed experiment measures what refitting a whole tree costs, per sphere and variant, by Google Benchmark.
#pragma once

#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

struct SpeedResult {
  std::string model, pose, variant;
  int level;                 // 0: all of them
  double ns_per_sphere;      // median over the repetitions
  double ratio_to_repaired;  // median over the repetitions of the ratio to spherical_repaired in the same repetition
};

// Times every sound variant (the others' time says nothing) on one thread. It refits all nodes of the tree in the pose, and, a
// tenth as long, those of each level. The frame's joint-set data are given. Only variants whose enclosure is tested are timed.
std::vector<SpeedResult> run_speed(const AnimatedCharacter& character, const NamedPose& pose, const SpeedSettings& settings);

// Writes all results as out/results/speed.csv.
void write_speed(const std::vector<SpeedResult>& results, const std::string& path);

}  // namespace refitlab
