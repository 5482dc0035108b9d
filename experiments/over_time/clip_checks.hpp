// SPDX-License-Identifier: GPL-3.0-or-later
// These check one clip: whether a vertex gets out of the bounds over time, or out of boxes around sampled times, and how tight
// they are.
#pragma once

#include <string>
#include <vector>

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

struct OverTimeSettings {
  int random_times = 200;  // of a clip
  int halvings = 6;        // of the steps before and after the time at which a part is farthest out
  int exact_checks = 8;    // in many digits, of the places that are closest to bounds
  int clips = 0;           // of a model at most; 0 for all
  std::uint64_t seed = 2006;
};

// A Miss is the vertex that gets out of a bound farther than all others.
struct Miss {
  int vertex = -1;  // of the model; none where there is no miss
  double time = 0;  // seconds
  double by = 0;    // as a share of the bound's longest side
};

// ClipMisses count the whole character and the clusters out of whose bound a vertex gets.
struct ClipMisses {
  std::string way;  // bounds; or boxes around the vertices at keys, at 30 Hz or at 60 Hz
  Miss of_whole;
  long clusters = 0;
  int worst_cluster = -1;
  Miss of_cluster;     // of the worst one
  long undecided = 0;  // parts of which many digits do not decide it either
};

struct ClipResult {
  std::string clip;
  double duration = 0;
  long random_times = 0, close_times = 0;  // that were looked at; close ones, of all parts together
  long places = 0;                         // of vertices
  // Of the places closest to our bounds, so many are checked in many digits, are outside, and are undecided, since the definition
  // does not say where they are.
  long exact_checks = 0, exact_misses = 0, exact_undecided = 0;
  // This is the volume of our box over that of a box around all places that were looked at. For clusters it is the mean over
  // those that are not flat. A whole that is flat has the ratio 1.
  double whole_ratio = 0, cluster_ratio = 0;
  long flat_clusters = 0;
  std::vector<ClipMisses> misses;  // by way
};

// Returns the parts that are compared, by position in ModelBounds::parts. They are the whole character and its clusters.
std::vector<std::size_t> compared_parts(const ModelBounds& bounds);

// Checks the clip of the model that the bounds have at this position. sets are those of the model.
ClipResult check_clip(const Model& model, const JointSets& sets, const ModelBounds& bounds, std::size_t clip,
                      const OverTimeSettings& settings);

}  // namespace refitlab
