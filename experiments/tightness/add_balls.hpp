// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of all nodes in one pose are counted in their levels.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "experiments/tightness/levels.hpp"
#include "experiments/tightness/misses.hpp"

namespace refitlab {

// Adds the balls of a pose to the levels. balls and optimal are by node. deformed has, by vertex, what the balls are to enclose.
// It is empty if they need not enclose anything. have_slack says whether the balls allow for rounding; then none is allowed here.
inline void add_balls(const Character& c, std::span<const Ball3<double>> balls, std::span<const Ball3<double>> optimal,
                      std::span<const Point3> deformed, bool have_slack, std::vector<LevelTightness>& levels) {
  const double tolerance = have_slack ? 0 : miss_tolerance * c.tree.nodes[0].reference.radius;
  levels.resize(static_cast<std::size_t>(c.tree.level_count()));
  for (std::size_t n = 0; n < balls.size(); ++n) {
    LevelTightness& level = levels[static_cast<std::size_t>(c.tree.nodes[n].level - 1)];
    ++level.nodes;
    if (!is_defined(balls[n])) {
      ++level.undefined;
      ++level.misses;
      continue;
    }
    level.radius_min = std::min(level.radius_min, balls[n].radius);
    level.radius_max = std::max(level.radius_max, balls[n].radius);
    level.radius_sum += balls[n].radius;
    level.optimal_sum += optimal[n].radius;
    if (deformed.empty()) continue;
    double out = 0;
    for (const int v : c.vertices[static_cast<int>(n)])
      out = std::max(out, excess(balls[n], deformed[static_cast<std::size_t>(v)]));
    if (out > tolerance) {
      ++level.misses;
      level.worst_miss = std::max(level.worst_miss, out);
    }
  }
}

}  // namespace refitlab
