// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/tightness/measure.hpp"

#include "algorithms/bake/parallel.hpp"
#include "algorithms/methods/refit/deformed.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/scenes/methods.hpp"

namespace refitlab {
namespace {

// "optimal" is of spherical blending.
constexpr std::pair<Skinning, const char*> other_optimal_columns[] = {{Skinning::linear, "optimal_linear"},
                                                                      {Skinning::dual_quaternion, "optimal_dual_quaternion"}};

// How far the farthest vertex of a node is outside its ball; at most 0 if none is.
double excess(const Ball3<double>& ball, std::span<const int> vertices, std::span<const Point3> deformed) {
  double far = 0;
  for (const int v : vertices) far = std::max(far, squared_distance(deformed[v], ball.center));
  return std::sqrt(far) - ball.radius;
}

// One pose: the balls of every column are measured against the vertices that they claim to bound.
class PoseMeasurement {
 public:
  PoseMeasurement(const AnimatedCharacter& c, const Pose& pose)
      : c_(c),
        pose_(pose),
        tolerance_(miss_tolerance * c.tree.nodes[0].reference.radius) {}

  Tightness all() {
    const Frame& spherical = frame(Skinning::spherical);
    std::vector<Ball3<double>> reference;
    for (const TreeNode& n : c_.tree.nodes) reference.push_back(n.reference);
    add("reference", reference, spherical, false);
    for (const Method& method : methods()) {
      const Frame& own = frame(method.variant->skinning);
      const auto balls = refit_all(c_, method, own.palette);
      add(method.name, balls, own, true);
      if (method.name == "linear") add("linear_under_spherical", balls, spherical, true);
    }
    add("bottom_up", refit_bottom_up(c_.tree, spherical.deformed), spherical, true);
    add("optimal", spherical.optimal, spherical, true);
    for (const auto& [skinning, column] : other_optimal_columns) add(column, frame(skinning).optimal, frame(skinning), true);
    return std::move(out_);
  }

 private:
  struct Frame {
    SkinningPalette<double> palette;
    std::vector<Point3> deformed;
    std::vector<Ball3<double>> optimal;
  };

  // Made when first asked for.
  const Frame& frame(Skinning s) {
    if (const auto known = frames_.find(s); known != frames_.end()) return known->second;
    Frame& f = frames_[s];
    f.palette = make_skinning_palette(c_.mesh, c_.sets, pose_, s);
    f.deformed = skin(c_.mesh, c_.sets, f.palette, s);
    f.optimal = optimal_balls(c_.tree, c_.vertices, f.deformed);
    return f;
  }

  void add(const std::string& column, const std::vector<Ball3<double>>& balls, const Frame& frame, bool must_enclose) {
    auto& levels = out_[column];
    levels.resize(c_.tree.level_count());
    for (std::size_t n = 0; n < balls.size(); ++n) {
      LevelTightness& level = levels[c_.tree.nodes[n].level - 1];
      ++level.nodes;
      if (!is_defined(balls[n])) {
        ++level.undefined;
        ++level.misses;
        continue;
      }
      level.radius_min = std::min(level.radius_min, balls[n].radius);
      level.radius_max = std::max(level.radius_max, balls[n].radius);
      level.radius_sum += balls[n].radius;
      level.optimal_sum += frame.optimal[n].radius;
      if (!must_enclose) continue;
      const double out = excess(balls[n], c_.vertices[static_cast<int>(n)], frame.deformed);
      if (out > tolerance_) {
        ++level.misses;
        level.worst_miss = std::max(level.worst_miss, out);
      }
    }
  }

  const AnimatedCharacter& c_;
  const Pose& pose_;
  const double tolerance_;
  std::map<Skinning, Frame> frames_;
  Tightness out_;
};

}  // namespace

std::vector<std::string> tightness_columns() {
  std::vector<std::string> columns{"reference"};
  for (const Method& c : methods()) {
    columns.push_back(c.name);
    if (c.name == "linear") columns.push_back("linear_under_spherical");
  }
  columns.insert(columns.end(), {"bottom_up", "optimal"});
  for (const auto& [skinning, column] : other_optimal_columns) columns.push_back(column);
  return columns;
}

Tightness measure_tightness(const AnimatedCharacter& character, const PoseSet& set) {
  std::vector<Tightness> parts(set.poses.size());
  parallel_for(set.poses.size(), [&](std::size_t i) { parts[i] = PoseMeasurement(character, set.poses[i]).all(); });
  Tightness total = std::move(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i)  // in order, so that sums do not depend on the threads
    for (auto& [column, levels] : total)
      for (std::size_t l = 0; l < levels.size(); ++l) levels[l].merge(parts[i][column][l]);
  return total;
}

}  // namespace refitlab
