// SPDX-License-Identifier: GPL-3.0-or-later
// These numbers of one level of a tree are merged over poses and models.
#pragma once

#include <algorithm>

namespace refitlab {

// A LevelTightness is that of one variant's balls on one level, over the poses of a set.
struct LevelTightness {
  long nodes = 0;      // balls seen: nodes of the level times poses
  long undefined = 0;  // of them not a number or of negative radius; left out of the radii
  double radius_min = 1e300, radius_max = 0, radius_sum = 0;
  double optimal_sum = 0;  // of the optimal radii of the same balls
  long misses = 0;         // balls with a vertex outside (an undefined ball is one)
  double worst_miss = 0;   // how far outside, in model units, over the balls that are defined
  double radius_avg() const { return radius_sum / static_cast<double>(nodes - undefined); }
  double ratio_to_optimal() const { return radius_sum / optimal_sum; }
  void merge(const LevelTightness& o) {
    nodes += o.nodes;
    undefined += o.undefined;
    radius_min = std::min(radius_min, o.radius_min);
    radius_max = std::max(radius_max, o.radius_max);
    radius_sum += o.radius_sum;
    optimal_sum += o.optimal_sum;
    misses += o.misses;
    worst_miss = std::max(worst_miss, o.worst_miss);
  }
};

// LevelVolumes are one variant's volumes on one level, over the poses of a set.
struct LevelVolumes {
  long nodes = 0;   // volumes seen
  long misses = 0;  // of them with a deformed vertex outside, by more than rounding
  double size_sum = 0;
  double optimal_sum = 0;       // of the sizes of the same kind of volume around the deformed vertices themselves
  double ball_sum = 0;          // of the radii of the same nodes' balls of control_mixed
  long solid_nodes = 0;         // those with a ball that has a volume
  double volume_ratio_sum = 0;  // of these nodes, volume / volume of that ball
  double ratio_to_optimal() const { return size_sum / optimal_sum; }
  double size_to_ball() const { return size_sum / ball_sum; }
  double volume_to_ball() const { return volume_ratio_sum / static_cast<double>(solid_nodes); }
  void merge(const LevelVolumes& o) {
    nodes += o.nodes;
    misses += o.misses;
    size_sum += o.size_sum;
    optimal_sum += o.optimal_sum;
    ball_sum += o.ball_sum;
    solid_nodes += o.solid_nodes;
    volume_ratio_sum += o.volume_ratio_sum;
  }
};

}  // namespace refitlab
