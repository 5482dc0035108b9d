// SPDX-License-Identifier: GPL-3.0-or-later
// These check one crossfade: whether a vertex gets out of the bounds while one clip fades to another, and how tight they are.
#pragma once

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

struct CrossfadeSettings {
  int times = 17;               // of each clip, evenly spaced from its start to its end
  int weights = 9;              // from 0 to 1
  int clips = 0;                // of a model at most; 0 for all
  int cluster_triangles = 128;  // of a cluster at most; 0 for no clusters
  bool all_skinnings = false;   // else linear skinning only
};

struct CrossfadeResult {
  std::string first, second;  // the clips' names
  long places = 0;            // of vertices
  // These count the whole character and the clusters out of whose bound a vertex gets, and those for which rounding leaves it
  // open.
  long outside = 0, undecided = 0;
  // This is the volume of our box over that of a box around all places that were looked at. For clusters it is the mean over
  // those that are not flat.
  double whole_ratio = 0, cluster_ratio = 0;
  long clusters = 0, flat_clusters = 0;
  // This counts the whole character and the clusters that leave the box around the bounds of both clips.
  long out_of_both_clips = 0;
};

// Checks the crossfade of the model that the bounds have at this position. sets are those of the model.
CrossfadeResult check_crossfade(const Model& model, const JointSets& sets, const ModelBounds& bounds, std::size_t crossfade,
                                const CrossfadeSettings& settings);

}  // namespace refitlab
