// SPDX-License-Identifier: GPL-3.0-or-later
// A page about one baked file: the character in its clips with its boxes, and what boxes of sampled times would have missed.
#pragma once

#include <string>

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

// What is looked at at the keys' times, or at a fixed rate, in one clip, and what is outside of its boxes at other times.
struct SampledMisses {
  int clusters = 0;  // of which some vertex leaves the box of the sampled times
  int worst = -1;    // the cluster that is left by most, by position among the clusters; -1 for none
  double by = 0;     // by how much, as a share of the longest side of that cluster's box
  double time = 0;   // when, in seconds
};

enum class Sampling { keys, fixed_rate };
inline constexpr double sampled_rate = 30;  // times a second

// By looking at more times than that: misses that are not seen are not counted. Needs clusters.
SampledMisses misses_of_sampling(const Model& model, const ModelBounds& bounds, std::size_t clip, Sampling sampling);

// The page: HTML, with everything in it.
std::string report_page(const Model& model, const ModelBounds& bounds, const std::string& file);

}  // namespace refitlab
