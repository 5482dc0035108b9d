// SPDX-License-Identifier: GPL-3.0-or-later
// The report is a page about one baked file. It shows the character in its clips with its boxes, and what boxes of sampled times
// would have missed.
#pragma once

#include <string>

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

// SampledMisses counts how one clip leaves, at other times, the boxes made at its keys' times or at a fixed rate.
struct SampledMisses {
  int clusters = 0;  // of which some vertex leaves the box of the sampled times
  int worst = -1;    // the cluster that is left by most, by position among the clusters; -1 for none
  double by = 0;     // by how much, as a share of the longest side of that cluster's box
  double time = 0;   // when, in seconds
};

enum class Sampling { keys, fixed_rate };
inline constexpr double sampled_rate = 30;  // times a second

// Counts misses by looking at more times than that. Misses at other times are not seen. The bounds must have clusters.
SampledMisses misses_of_sampling(const Model& model, const ModelBounds& bounds, std::size_t clip, Sampling sampling);

// Throws ModelError for a clip that is too long to be sampled. file is for the message.
void check_report(const Model& model, const std::string& file);

// Returns the page as HTML with everything in it.
std::string report_page(const Model& model, const ModelBounds& bounds, const std::string& file);

}  // namespace refitlab
