// SPDX-License-Identifier: GPL-3.0-or-later
// What the experiments make of their measurements: medians, and levels merged from parts.
#include <algorithm>
#include <cmath>

#include "experiments/speed/statistics.hpp"
#include "experiments/tightness/levels.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_experiment_statistics {
namespace {

using namespace refitlab;

// By sorting.
double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Ball {
  double radius, optimal, miss;  // NaN: undefined; 0: no miss
};

// As experiments/tightness adds a ball.
LevelTightness level_of(const std::vector<Ball>& balls) {
  LevelTightness out;
  for (const Ball& b : balls) {
    ++out.nodes;
    if (std::isnan(b.radius)) {
      ++out.undefined, ++out.misses;
      continue;
    }
    out.radius_min = std::min(out.radius_min, b.radius), out.radius_max = std::max(out.radius_max, b.radius);
    out.radius_sum += b.radius, out.optimal_sum += b.optimal;
    out.misses += b.miss > 0, out.worst_miss = std::max(out.worst_miss, b.miss);
  }
  return out;
}

// Numbers that are sums of few halves: exact in any order.
double half(int most) { return *rc::gen::inRange(0, 2 * most) / 2.; }

}  // namespace

PROPTEST(experiment_statistics) {
  t.holds("the median is the middle of the sorted values, whatever their order", {.cases = 1000}, [] {
    const auto count = *rc::gen::inRange(1, 12);
    std::vector<double> values, base, ratios;
    for (int i = 0; i < count; ++i) {
      values.push_back(half(8)), base.push_back(1 + half(8));
      ratios.push_back(values.back() / base.back());
    }
    RC_ASSERT(median(values) == middle_of(values));
    RC_ASSERT(median_ratio(values, base) == middle_of(ratios));
  });
  t.example("a ratio is of the same repetition, not of two medians", {}, [] {
    return median_ratio({1, 4, 9}, {1, 2, 9}) == 1 && median_ratio({10, 4, 9}, {1, 2, 30}) == 2;
  });
  t.holds("merged parts of a level are the level of all balls, each number of it", {.cases = 500}, [] {
    const auto count = *rc::gen::inRange(0, 10), first = *rc::gen::inRange(0, count + 1);
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i)
      balls.push_back({*rc::gen::inRange(0, 4) ? half(20) : std::nan(""), half(20), *rc::gen::inRange(0, 2) ? half(4) : 0});
    const LevelTightness all = level_of(balls);
    LevelTightness merged = level_of({balls.begin(), balls.begin() + first});
    merged.merge(level_of({balls.begin() + first, balls.end()}));
    RC_ASSERT(merged.nodes == all.nodes && merged.undefined == all.undefined && merged.misses == all.misses);
    RC_ASSERT(merged.radius_min == all.radius_min && merged.radius_max == all.radius_max);
    RC_ASSERT(merged.radius_sum == all.radius_sum && merged.optimal_sum == all.optimal_sum &&
              merged.worst_miss == all.worst_miss);
  });
  t.example("averages are over the balls that are defined, ratios of sums", {}, [] {
    const LevelTightness level = level_of({{3, 2, 0}, {5, 2, 1}, {std::nan(""), 7, 0}});
    return level.radius_avg() == 4 && level.ratio_to_optimal() == 2 && level.misses == 2 && level.worst_miss == 1;
  });
  t.example("merged volumes have the sums of each number", {}, [] {
    LevelVolumes level{1, 2, 3, 4, 5, 6, 7};
    level.merge({10, 20, 30, 40, 50, 60, 70});
    return level.nodes == 11 && level.misses == 22 && level.size_sum == 33 && level.optimal_sum == 44 && level.ball_sum == 55 &&
           level.solid_nodes == 66 && level.volume_ratio_sum == 77 && level.size_avg() == 3 && level.ratio_to_optimal() == 0.75 &&
           level.size_to_ball() == 0.6 && level.volume_to_ball() == 77. / 66;
  });
}

}  // namespace proptests::suite_experiment_statistics
