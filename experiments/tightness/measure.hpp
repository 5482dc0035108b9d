// SPDX-License-Identifier: GPL-3.0-or-later
// Tightness is, per level, how large each variant's balls are beside the optimal ones, and what they miss.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"
#include "experiments/tightness/levels.hpp"
#include "experiments/tightness/misses.hpp"

namespace refitlab {

using Tightness = std::map<std::string, std::vector<LevelTightness>>;  // by variant, by level - 1

// Returns the columns of the experiment in the order of the report: "reference", every method, "linear_under_spherical" (the
// linear refit against spherically skinned vertices), "bottom_up", "optimal", "optimal_linear" and "optimal_dual_quaternion".
std::vector<std::string> tightness_columns();

// Measures all variants in all poses of the set, on all processors.
Tightness measure_tightness(const AnimatedCharacter& character, const PoseSet& poses);

}  // namespace refitlab
