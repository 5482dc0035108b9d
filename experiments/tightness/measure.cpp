// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/tightness/measure.hpp"

#include "algorithms/bake/parallel.hpp"
#include "algorithms/methods/refit/deformed.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/methods.hpp"
#include "experiments/tightness/add_balls.hpp"

namespace refitlab {
namespace {

// The column "optimal" is for spherical blending.
constexpr std::pair<Skinning, const char*> other_optimal_columns[] = {{Skinning::linear, "optimal_linear"},
                                                                      {Skinning::dual_quaternion, "optimal_dual_quaternion"}};

// A PoseMeasurement measures, in one pose, the balls of every column against the vertices that they claim to bound.
class PoseMeasurement {
 public:
  PoseMeasurement(const AnimatedCharacter& c, const Pose& pose) : c_(c), pose_(pose) {}

  Tightness all() {
    const Frame& spherical = frame(Skinning::spherical);
    std::vector<Ball3<double>> reference;
    for (const TreeNode& n : c_.tree.nodes) reference.push_back(n.reference);
    add("reference", reference, spherical, false);
    for (const Method& method : methods()) {
      const Frame& own = frame(method.variant->skinning);
      const auto balls = refit_all(c_, method, own.palette);
      add(method.name, balls, own, true, method.variant->sound);
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

  // Returns a frame, which is made when it is first asked for.
  const Frame& frame(Skinning s) {
    if (const auto known = frames_.find(s); known != frames_.end()) return known->second;
    Frame& f = frames_[s];
    f.palette = make_skinning_palette(c_.mesh, c_.sets, pose_, s);
    f.deformed = skin(c_.mesh, c_.sets, f.palette, s);
    f.optimal = optimal_balls(c_.tree, c_.vertices, f.deformed);
    return f;
  }

  void add(const std::string& column, const std::vector<Ball3<double>>& balls, const Frame& frame, bool must_enclose,
           bool have_slack = false) {
    add_balls(c_, balls, frame.optimal, must_enclose ? std::span<const Point3>(frame.deformed) : std::span<const Point3>(),
              have_slack, out_[column]);
  }

  const AnimatedCharacter& c_;
  const Pose& pose_;
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
