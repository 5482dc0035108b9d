// SPDX-License-Identifier: GPL-3.0-or-later
// The ball speed experiment measures what the smallest ball of few points costs, by kernel, against CGAL's.
#pragma once

#include <string>
#include <vector>

#include "experiments/speed/timing.hpp"

namespace refitlab {

struct BallSpeed {
  std::string clouds, space, variant;  // space: "R^3" or "R^4"
  int points;                          // of each cloud
  double ns;                           // a ball, the least of the repetitions
  double ratio_to_cgal;                // of the leasts
};

// Measures clouds of independent points, and those of the refit: images of one point under blends of three rotations, and the
// blends themselves. Throws std::runtime_error if two kernels that find smallest balls disagree about a radius.
std::vector<BallSpeed> run_ball_speed(const SpeedSettings& settings);

// Writes all results as out/results/ball_speed.csv.
void write_ball_speed(const std::vector<BallSpeed>& results, const std::string& path);

}  // namespace refitlab
