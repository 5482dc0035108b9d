// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what the experiments make of their measurements: medians, levels of balls and what these miss, and levels merged from
// parts.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/speed/statistics.hpp"
#include "experiments/tightness/add_balls.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_experiment_statistics {
namespace {

using namespace refitlab;
using Balls = std::vector<Ball3<double>>;
using Levels = std::vector<LevelTightness>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// Returns the median by sorting.
double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

const AnimatedCharacter& man() {
  static const AnimatedCharacter made = bake_animated(make_man(1034), {.triangles_per_leaf = 16}, {});
  return made;
}

double radius_of_man() { return man().tree.nodes[0].reference.radius; }

// Returns the smallest balls in the reference pose, by node.
Balls smallest_balls() {
  Balls out;
  for (const TreeNode& n : man().tree.nodes) out.push_back(n.reference);
  return out;
}
Balls large_balls() {
  Balls out = smallest_balls();
  for (Ball3<double>& ball : out) ball.radius *= 1.01;
  return out;
}

// Returns how far a node's vertices are at most from the center of its ball.
double reach(int node) {
  double far = 0;
  for (const int v : man().vertices[node])
    far = std::max(far, norm<double, 3>(man().mesh.vertices[v] - man().tree.nodes[node].reference.center));
  return far;
}

// Returns the first nodes of a level that has three of them.
std::vector<int> three_nodes() {
  for (int level = 1; level <= man().tree.level_count(); ++level) {
    std::vector<int> nodes = nodes_of_level(man().tree, level);
    if (nodes.size() < 3) continue;
    nodes.resize(3);
    return nodes;
  }
  return {};
}

// Returns the levels of balls in so many poses, in each of which the vertices are those of the mesh.
Levels levels_of(const std::vector<Balls>& poses, const Balls& optimal, bool have_slack = false) {
  Levels out(static_cast<std::size_t>(man().tree.level_count()));
  for (const Balls& balls : poses) add_balls(man(), balls, optimal, man().mesh.vertices, have_slack, out);
  return out;
}

LevelTightness all_of(const Levels& levels) {
  LevelTightness out;
  for (const LevelTightness& level : levels) out.merge(level);
  return out;
}

// Draws a multiple of a half. Sums of these are exact in any order.
double half(int most) { return *rc::gen::inRange(0, 2 * most) / 2.; }

// Returns balls around the right centers, of any radius, of which some are undefined.
Balls some_balls(std::mt19937& random) {
  std::uniform_int_distribution<int> halves(-1, 8);
  Balls out = smallest_balls();
  for (Ball3<double>& ball : out) ball.radius = halves(random) / 2.;
  out[random() % out.size()].radius = no_number;
  return out;
}

void medians(Suite& t) {
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
}

void levels_of_balls(Suite& t) {
  t.example("a ball that is half as large as needed misses a vertex, by the distance of the farthest one", {}, [] {
    Balls balls = large_balls();
    if (all_of(levels_of({balls}, balls)).misses != 0) return false;
    balls[0].radius = reach(0) / 2;
    const Levels levels = levels_of({balls}, balls);
    return levels[0].misses == 1 && std::abs(levels[0].worst_miss - reach(0) / 2) < 1e-12 && all_of(levels).misses == 1 &&
           all_of(levels).undefined == 0;
  });
  t.example("a ball that allows for rounding has to hold its vertices, and another one by the tolerance", {}, [] {
    for (const double share : {0.5, 2.})
      for (const bool has_slack : {false, true}) {
        Balls balls = large_balls();
        balls[0].radius = reach(0) - share * miss_tolerance * radius_of_man();
        const bool is_missed = has_slack || share > 1;
        if (all_of(levels_of({balls}, balls, has_slack)).misses != (is_missed ? 1 : 0)) return false;
      }
    return true;
  });
  t.example("a ball that is no number or has a negative radius is undefined, and misses", {}, [] {
    Balls balls = large_balls();
    balls[0].center[1] = no_number, balls[1].radius = -1, balls[2].radius = no_number;
    const LevelTightness all = all_of(levels_of({balls}, smallest_balls()));
    return all.nodes == static_cast<long>(balls.size()) && all.undefined == 3 && all.misses == 3 && all.worst_miss == 0 &&
           all.radius_min >= 0;
  });
  t.example("averages are over the balls that are defined, ratios of sums", {}, [] {
    Balls balls = smallest_balls(), optimal = balls;
    for (Ball3<double>& ball : balls) ball.radius = 4;
    for (Ball3<double>& ball : optimal) ball.radius = 2;
    const std::vector<int> nodes = three_nodes();
    balls[nodes[0]].radius = 3, balls[nodes[1]].radius = 5, balls[nodes[2]].radius = no_number, optimal[nodes[2]].radius = 7;
    const Levels levels = levels_of({balls}, optimal);
    const LevelTightness& level = levels[man().tree.nodes[nodes[0]].level - 1];
    return level.radius_avg() == 4 && level.ratio_to_optimal() == 2 && level.radius_min == 3 && level.radius_max == 5 &&
           level.undefined == 1 && level.misses == 1;
  });
  t.holds("merged parts of a level are the level of all balls, each number of it", {.cases = 100}, [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const auto count = *rc::gen::inRange(0, 5), first = *rc::gen::inRange(0, count + 1);
    std::vector<Balls> poses;
    for (int i = 0; i < count; ++i) poses.push_back(some_balls(random));
    Balls optimal = smallest_balls();
    for (Ball3<double>& ball : optimal) ball.radius = 0.5;
    const Levels all = levels_of(poses, optimal), rest = levels_of({poses.begin() + first, poses.end()}, optimal);
    Levels merged = levels_of({poses.begin(), poses.begin() + first}, optimal);
    for (std::size_t l = 0; l < all.size(); ++l) {
      merged[l].merge(rest[l]);
      RC_ASSERT(merged[l].nodes == all[l].nodes && merged[l].undefined == all[l].undefined && merged[l].misses == all[l].misses);
      RC_ASSERT(merged[l].radius_min == all[l].radius_min && merged[l].radius_max == all[l].radius_max);
      RC_ASSERT(merged[l].radius_sum == all[l].radius_sum && merged[l].optimal_sum == all[l].optimal_sum);
      RC_ASSERT(merged[l].worst_miss == all[l].worst_miss);
    }
  });
}

void misses_of_balls(Suite& t) {
  t.example("of balls, one is no ball, one too small, and one holds its vertices", {}, [] {
    const std::vector<int> nodes = three_nodes();
    Balls balls;
    for (const int n : nodes) balls.push_back(large_balls()[n]);
    balls[0].radius = no_number, balls[1].radius = reach(nodes[1]) / 2;
    const std::vector<Point3>& vertices = man().mesh.vertices;
    std::vector<bool> without(vertices.size()), outside(vertices.size());
    for (const int v : man().vertices[nodes[0]]) without[v] = true;
    for (const int v : man().vertices[nodes[1]])
      outside[v] = norm<double, 3>(vertices[v] - balls[1].center) > balls[1].radius + 1e-9;
    const Misses misses = find_misses(man(), nodes, balls, vertices);
    return misses.balls == std::vector<bool>{true, true, false} && misses.ball_count() == 2 && misses.undefined == 1 &&
           misses.worst_ball == 1 && std::abs(misses.worst - reach(nodes[1]) / 2) < 1e-12 && misses.without == without &&
           misses.outside == outside && misses.outside_count() > 0;
  });
}

}  // namespace

PROPTEST(experiment_statistics) {
  medians(t);
  levels_of_balls(t);
  misses_of_balls(t);
  t.example("merged volumes have the sums of each number", {}, [] {
    LevelVolumes level{1, 2, 3, 4, 5, 6, 7};
    level.merge({10, 20, 30, 40, 50, 60, 70});
    return level.nodes == 11 && level.misses == 22 && level.size_sum == 33 && level.optimal_sum == 44 && level.ball_sum == 55 &&
           level.solid_nodes == 66 && level.volume_ratio_sum == 77 && level.ratio_to_optimal() == 0.75 &&
           level.size_to_ball() == 0.6 && level.volume_to_ball() == 77. / 66;
  });
}

}  // namespace proptests::suite_experiment_statistics
