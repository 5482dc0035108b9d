// SPDX-License-Identifier: GPL-3.0-or-later
// The rounding experiment measures what certifying a refit in floating point adds to its radius and costs. It also counts the
// exactly skinned vertices outside a ball. With the slack for rounding there may be none.
#pragma once

#include <string>
#include <vector>

#include "algorithms/bake/bake.hpp"
#include "experiments/scenes/scenes.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

struct RoundingSettings {
  int poses = 6;              // of all clips together
  int vertices_per_node = 4;  // the one that comes out farthest from the center, and others at random
  SpeedSettings speed;
  std::uint64_t seed = 2006;
};

struct RoundingResult {
  std::string model, variant;
  // These count exact checks of vertices against balls: all of them, those outside the ball, outside the same ball rounded to
  // float, and outside the ball without the slack.
  long checks = 0, misses = 0, float_misses = 0, misses_as_computed = 0;
  // The slack, and rounding to float after it, add this share to the radius, as a median over nodes and poses.
  double inflation = 0, float_inflation = 0;
  double cost = 0;  // processor time with the slack over that without, in one pose
};

// Runs the experiment on every sound variant. Progress goes to stdout.
std::vector<RoundingResult> run_rounding(const AnimatedCharacter& character, const NamedPose& timed,
                                         const RoundingSettings& settings);

void write_rounding(const std::vector<RoundingResult>& results, const RoundingSettings& settings, const std::string& path);

}  // namespace refitlab
