// SPDX-License-Identifier: GPL-3.0-or-later
// The tightness experiment makes Table 1 for every model and pose, with what each variant misses.
#pragma once

#include <string>
#include <vector>

#include "experiments/scenes/animated_character.hpp"
#include "experiments/tightness/measure.hpp"

namespace refitlab {

struct TightnessResult {
  std::string model, pose, pose_kind;  // pose_kind: "clip", "twist" or "worst_twist"
  int poses;                           // how many were sampled
  Tightness tightness;
};

struct TightnessSettings {
  int times_per_clip = 50;
};

// Runs all clips of one model, and these poses, with progress on stdout, and prints its tables.
std::vector<TightnessResult> run_tightness(const AnimatedCharacter& character, const std::vector<NamedPose>& poses,
                                           const TightnessSettings& settings);

// Writes all results as out/results/tightness.csv.
void write_tightness(const std::vector<TightnessResult>& results, const std::string& path);

}  // namespace refitlab
