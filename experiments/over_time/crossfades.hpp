// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment on crossfades measures whether a vertex gets out of the bounds between two clips, how much larger than needed
// the bounds are, and how long baking them takes.
#pragma once

#include "experiments/over_time/crossfade_checks.hpp"

namespace refitlab {

struct CrossfadesResult {
  std::string model;
  Skinning skinning;
  double seconds = 0;                       // of bounding all clips and crossfades, on all processors
  std::string refused;                      // why there is no bound; empty where there are
  std::vector<CrossfadeResult> crossfades;  // of each two clips that were looked at
};

// Returns the results by skinning. A model with fewer than two clips has none. Progress goes to stdout.
std::vector<CrossfadesResult> run_crossfades(const Model& model, const CrossfadeSettings& settings);

void write_crossfades(const std::vector<CrossfadesResult>& results, const std::string& path);

}  // namespace refitlab
