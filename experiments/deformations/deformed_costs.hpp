// SPDX-License-Identifier: GPL-3.0-or-later
// This measures what refitting a deformed character costs beside a rigid one.
#pragma once

#include <string>
#include <vector>

#include "algorithms/bake/bake.hpp"
#include "experiments/deformations/deforming.hpp"
#include "experiments/deformations/reduced_measures.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

// A DeformedCost is the cost of all nodes of a character, by one variant.
struct DeformedCost {
  std::string kind, variant;
  double ns_per_sphere;  // where the deformation is another one in every frame; medians over the repetitions
  double to_rigid;       // the same over the rigid character's, the median of the ratios
  double to_rigid_kept;  // likewise where the deformation stays as it is, and only the rigid pose changes
};

// Times the default variants.
std::vector<DeformedCost> deformed_costs(const DeformingCharacters& characters, const SpeedSettings& settings);

// A ReducedCost is the cost of all nodes of a character with a reduced deformation in its reference pose, with new coordinates in
// every frame.
struct ReducedCost {
  std::string variant;  // as in ReducedMeasure
  DisplacementBalls balls;
  double ns_per_sphere, to_bd_tree;  // medians over the repetitions, of the ratio too
};

std::vector<ReducedCost> reduced_costs(const ReducedCharacter& character, const SpeedSettings& settings);

}  // namespace refitlab
