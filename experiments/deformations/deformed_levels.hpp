// SPDX-License-Identifier: GPL-3.0-or-later
// How tight refits of deformed characters are: level by level, the radii of their balls beside those of the smallest balls of the
// deformed and skinned vertices, and what they miss.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/refit/variants.hpp"
#include "experiments/deformations/deformed_pose.hpp"
#include "experiments/tightness/levels.hpp"

namespace refitlab {

// Returns what these variants, which bound one skinning, have in all poses, by variant and by level - 1; on all processors. character
// has the pieces of the variants.
std::vector<std::vector<LevelTightness>> deformed_levels(const Character& character,
                                                         std::span<const RefitVariant* const> variants,
                                                         std::span<const DeformedPose> poses);

// The level whose balls are largest beside the smallest ones, from 1.
struct WorstLevel {
  double ratio = 0;
  int level = 0;
};
WorstLevel worst_level(std::span<const LevelTightness> levels);

// Returns how many balls of all levels miss a vertex.
long all_misses(std::span<const LevelTightness> levels);

}  // namespace refitlab
