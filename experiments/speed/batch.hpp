// SPDX-License-Identifier: GPL-3.0-or-later
// The batch experiment compares skinning, refitting a whole tree, bounding the nodes that a query opens and preparing a palette in
// SIMD packs with taking one vertex, node or joint-set after the other in double.
#pragma once

#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

struct BatchSpeed {
  std::string model, pose;
  std::string what;        // "skin_linear", ..., "refit_linear", "refit_spherical", "bound_opened_nodes", "skinning_palette"
  std::string how;         // "scalar", or a target of packs
  std::string item;        // that ns is for: "vertex", "sphere", "node", "joint_set"
  double ns;               // median over the repetitions
  double ratio;            // to scalar, the median over the repetitions
  double to_linear;        // of refits: to the linear refit done the same way, which is timed apart, a ratio of medians; else 0
  double chain_share = 0;  // of scalar refits: that of a sphere's longest chain of operations (longest_chain.hpp) in ns; else 0
  double lanes_used = 0;   // of refits in packs: the share of lanes that have a weight vertex of their own; else 0
};

// Measures every available target. Throws std::logic_error if a batch's result is wrong, that is, if skinned vertices are not
// bit-identical or a ball misses a vertex.
std::vector<BatchSpeed> run_batch_speed(const AnimatedCharacter& character, const NamedPose& pose, const SpeedSettings& settings);

// Writes all results as out/results/batch_speed.csv.
void write_batch_speed(const std::vector<BatchSpeed>& results, const std::string& path);

}  // namespace refitlab
