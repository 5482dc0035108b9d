// Tightness against cost: which refit variant is best at which price.
#pragma once

#include <string>
#include <vector>

#include "experiments/speed/speed.hpp"
#include "experiments/tightness/tightness.hpp"

namespace refitlab {

// One variant on one model.
struct Price {
  std::string variant;
  Skinning skinning;
  double ns_per_sphere, ratio_to_repaired;  // of the whole tree
  double mean_ratio;   // of average radius / Optimal, over all levels and posture sets
  double worst_ratio;  // of these the largest
  long misses;         // balls with a vertex outside
  bool on_front;       // no other variant of this skinning is as cheap and has a smaller worst_ratio
};

// The variants of a model that were timed and measured, cheapest first.
std::vector<Price> prices(const std::vector<SpeedResult>& speed, const std::vector<TightnessResult>& tightness,
                          const std::string& model);

// The section of the report: plots, tables and what follows from them; empty if one of the experiments was not run.
std::string pareto_section(const std::vector<SpeedResult>& speed, const std::vector<TightnessResult>& tightness);

}  // namespace refitlab
