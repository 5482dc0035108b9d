// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment on bounds over time measures whether a vertex is ever outside of the bounds of a clip, or of boxes around
// sampled times, how much larger than needed the bounds are, and how long baking them takes.
#pragma once

#include <string>
#include <vector>

#include "experiments/over_time/clip_checks.hpp"

namespace refitlab {

struct OverTimeResult {
  std::string model;
  Skinning skinning;
  long triangles = 0, clusters = 0;
  double seconds = 0;                // of bounding all clips, on all processors
  std::vector<std::string> refused;  // clips that have no bound, and why
  std::vector<ClipResult> clips;     // the others
};

// Returns the model with a skeleton of keys. It is the model as it is, or it gets ten keys a second for each clip, as an animator
// sets them. Only the first clips are kept, if most_clips is not 0.
Model with_keys(const Model& made, int most_clips = 0);

// Returns the results by skinning. Progress goes to stdout.
std::vector<OverTimeResult> run_over_time(const Model& model, const OverTimeSettings& settings);

void write_over_time(const std::vector<OverTimeResult>& results, const OverTimeSettings& settings, const std::string& path);

}  // namespace refitlab
