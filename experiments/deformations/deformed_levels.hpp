// SPDX-License-Identifier: GPL-3.0-or-later
// This measures how tight refits of deformed characters are. Level by level, it compares the radii of their balls with those of
// the smallest balls of the deformed and skinned vertices, and counts what they miss.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/refit/variants.hpp"
#include "experiments/deformations/deformed_pose.hpp"
#include "experiments/tightness/levels.hpp"

namespace refitlab {

// Returns the tightness of these variants, which bound one skinning, in all poses, by variant and by level - 1. It uses all
// processors. character must have the pieces of the variants.
std::vector<std::vector<LevelTightness>> deformed_levels(const Character& character,
                                                         std::span<const RefitVariant* const> variants,
                                                         std::span<const DeformedPose> poses);

// The WorstLevel, from 1, has the largest balls beside the smallest possible ones.
struct WorstLevel {
  double ratio = 0;
  int level = 0;
};
WorstLevel worst_level(std::span<const LevelTightness> levels);

// Returns how many balls of all levels miss a vertex.
long all_misses(std::span<const LevelTightness> levels);

}  // namespace refitlab
