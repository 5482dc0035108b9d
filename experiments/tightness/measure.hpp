// Measuring tightness: per level, how large each variant's balls are beside the optimal ones, and what they miss.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"
#include "experiments/tightness/misses.hpp"

namespace refitlab {

// Of one variant's balls on one level, over the postures of a set.
struct LevelTightness {
  long nodes = 0;                     // balls seen: nodes of the level times postures
  long undefined = 0;                 // of them not a number or of negative radius; left out of the radii
  double radius_min = 1e300, radius_max = 0, radius_sum = 0;
  double optimal_sum = 0;             // of the optimal radii of the same balls
  long misses = 0;                    // balls with a vertex outside (an undefined ball is one)
  double worst_miss = 0;              // how far outside, in model units, over the balls that are defined
  double radius_avg() const { return radius_sum / static_cast<double>(nodes - undefined); }
  double ratio_to_optimal() const { return radius_sum / optimal_sum; }
  void merge(const LevelTightness& other);
};

using Tightness = std::map<std::string, std::vector<LevelTightness>>;  // by variant, by level - 1

// The columns of the experiment in the order of the report: "reference", every contender, "linear_under_spherical"
// (the linear refit against spherically skinned vertices), "bottom_up", "optimal", "optimal_linear" and
// "optimal_dual_quaternion".
std::vector<std::string> tightness_columns();

// All variants in all postures of the set, on all processors.
Tightness measure_tightness(const Character& character, const PostureSet& postures);

}  // namespace refitlab
