// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment on bounds over time: whether a vertex is ever outside of the bounds of a clip, or of boxes around sampled times,
// how much larger than needed the bounds are, and how long baking them takes.
#pragma once

#include <string>
#include <vector>

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

struct OverTimeSettings {
  int random_times = 200;  // of a clip
  int halvings = 6;        // of the steps before and after the time at which a part is farthest out
  int exact_walls = 1;     // of each part: so many of the walls that a vertex comes closest to are checked in many digits
  int clips = 0;           // of a model at most; 0 for all
  std::uint64_t seed = 2006;
};

// Of the whole character and of its clusters, those out of whose bound a vertex gets.
struct ClipMisses {
  std::string way;                  // bounds; or boxes around the vertices at keys, at 30 Hz or at 60 Hz
  bool whole_missed = false;
  double whole_by = 0;              // at most, as a share of the bound's longest side
  long clusters = 0;
  double cluster_by = 0;            // the same, of the worst cluster
  int cluster = -1, vertex = -1;    // where that is
  double time = 0;
  long undecided = 0;               // parts of which many digits do not decide it either
};

struct ClipResult {
  std::string clip;
  double duration = 0;
  long random_times = 0, close_times = 0;  // that were looked at; close ones, of all parts together
  long places = 0;                         // of vertices
  // Of places closest to our bounds: checked in many digits, outside, and undecided since the definition does not say where
  // they are.
  long exact_checks = 0, exact_misses = 0, exact_undecided = 0;
  // The volume of our box over that of a box around all places that were looked at; of clusters the mean over those that are
  // not flat.
  double whole_ratio = 0, cluster_ratio = 0;
  long flat_clusters = 0;
  std::vector<ClipMisses> misses;  // by way
};

struct OverTimeResult {
  std::string model;
  Skinning skinning;
  long triangles = 0, clusters = 0;
  double seconds = 0;                // of bounding all clips, on all processors
  std::vector<std::string> refused;  // clips that have no bound, and why
  std::vector<ClipResult> clips;     // the others
};

// With a skeleton of keys: as it is, or with ten keys a second of each clip, as an animator sets them.
Model with_keys(const Model& model);

// By skinning. Progress on stdout.
std::vector<OverTimeResult> run_over_time(const Model& model, const OverTimeSettings& settings);

void write_over_time(const std::vector<OverTimeResult>& results, const OverTimeSettings& settings, const std::string& path);

}  // namespace refitlab
