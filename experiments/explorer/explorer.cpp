// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/explorer/explorer.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/explorer/packed_model.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/twist.hpp"
#include "experiments/tightness/misses.hpp"

namespace refitlab {
namespace {

constexpr int snake_joints = 24;

Pose pose_of(const AnimatedCharacter& c, const ExplorerSettings& s) {
  if (s.joint < 0 || s.joint >= static_cast<int>(c.mesh.joints.size())) throw std::invalid_argument("no such joint");
  Pose pose = reference_pose(c.mesh);
  if (!s.clip.empty()) {
    const auto clip = std::find_if(c.clips.begin(), c.clips.end(), [&](const Clip& known) { return known.name == s.clip; });
    if (clip == c.clips.end()) throw std::invalid_argument("no clip named '" + s.clip + "'");
    pose = clip->sample(std::clamp(s.time, 0., clip->duration));
  }
  return twisted(c.mesh, std::move(pose), s.joint, s.twist);
}

// A Frame is a skinning of the pose, and the smallest balls of the level's nodes under it.
struct Frame {
  SkinningPalette<double> palette;
  std::vector<Point3> vertices;
  std::vector<double> optimal_radii;
};

class LevelView {
 public:
  LevelView(const AnimatedCharacter& character, const Pose& pose, int level)
      : c_(character),
        pose_(pose),
        nodes_(nodes_of_level(character.tree, level)) {}

  const std::vector<int>& nodes() const { return nodes_; }

  const Frame& frame(Skinning skinning) {
    if (const auto known = frames_.find(skinning); known != frames_.end()) return known->second;
    Frame& f = frames_[skinning];
    f.palette = make_skinning_palette(c_.mesh, c_.sets, pose_, skinning);
    f.vertices = skin(c_.mesh, c_.sets, f.palette, skinning);
    std::vector<Point3> points;
    for (const int node : nodes_) {
      points.clear();
      for (const int v : c_.vertices[node]) points.push_back(f.vertices[v]);
      f.optimal_radii.push_back(std::sqrt(smallest_ball<double, 3>(points).squared_radius));
    }
    return f;
  }

  std::vector<Ball3<double>> balls(const RefitVariant& variant) {
    const Frame& f = frame(variant.skinning);
    std::vector<Ball3<double>> out;
    for (const int node : nodes_) out.push_back(variant.refit(c_.refit_node(node, f.palette, variant.pieces)));
    return out;
  }

  // Sums up a variant's balls, and marks what is outside in view, if there is one.
  VariantSummary summarise(const RefitVariant& variant, const std::vector<Ball3<double>>& balls, ExplorerView* view) {
    const Frame& f = frame(variant.skinning);
    Misses misses = find_misses(c_, nodes_, balls, f.vertices);
    VariantSummary out{variant.name, static_cast<int>(balls.size()), misses.undefined, static_cast<int>(misses.outside_count()),
                       misses.worst};
    double radii = 0, optimal = 0;
    for (std::size_t b = 0; b < balls.size(); ++b)
      if (is_defined(balls[b])) radii += balls[b].radius, optimal += f.optimal_radii[b];
    out.mean_radius = radii / (out.balls - out.undefined);
    out.mean_over_optimal = radii / optimal;
    if (view) view->outside = std::move(misses.outside), view->misses = std::move(misses.balls);
    return out;
  }

 private:
  const AnimatedCharacter& c_;
  const Pose& pose_;
  std::vector<int> nodes_;
  std::map<Skinning, Frame> frames_;
};

}  // namespace

Explorer::Explorer()
    : makers_{{"man", [] { return make_man(); }},
              {"creature", [] { return make_creature(); }},
              {"snake", [] { return make_snake(snake_joints); }}} {}

void Explorer::add(const std::vector<std::uint8_t>& packed) {
  Model model = unpack(packed);
  makers_.push_back({model.name, [model] { return model; }});
}

std::vector<std::string> Explorer::models() const {
  std::vector<std::string> names;
  for (const Maker& m : makers_) names.push_back(m.name);
  return names;
}

const std::vector<std::string>& shown_variants() {
  static const std::vector<std::string> names{
      "linear",       "spherical_printed", "spherical_printed_signed", "spherical_repaired", "spherical_miniball",
      "control_mean", "control_mixed"};
  return names;
}

const AnimatedCharacter& Explorer::character(const std::string& model) {
  if (const auto known = characters_.find(model); known != characters_.end()) return known->second;
  for (const Maker& m : makers_)
    if (m.name == model) return characters_.emplace(model, bake_animated(m.make())).first->second;
  throw std::invalid_argument("no model named '" + model + "'");
}

ExplorerView Explorer::view(const ExplorerSettings& s) {
  const AnimatedCharacter& c = character(s.model);
  const RefitVariant& chosen = compared_variant(s.variant);
  const Pose pose = pose_of(c, s);
  LevelView level(c, pose, std::clamp(s.level, 1, c.tree.level_count()));

  ExplorerView view;
  view.level_count = c.tree.level_count();
  view.vertices = level.frame(chosen.skinning).vertices;
  for (std::size_t j = 0; j < pose.size(); ++j) view.joints.push_back(apply(pose[j], c.mesh.joints[j].origin));
  view.axis = rotate<double>(pose[s.joint].rotation, bone_axis(c.mesh, s.joint));
  view.balls = level.balls(chosen);
  view.ball = std::clamp(s.ball, 0, static_cast<int>(view.balls.size()) - 1);
  view.ball_vertices = static_cast<int>(c.vertices[level.nodes()[view.ball]].size());
  view.ball_optimal = level.frame(chosen.skinning).optimal_radii[view.ball];

  std::vector<std::string> names = shown_variants();
  if (std::find(names.begin(), names.end(), s.variant) == names.end()) names.push_back(s.variant);
  for (const std::string& name : names) {
    const RefitVariant& variant = compared_variant(name);
    const auto balls = name == s.variant ? view.balls : level.balls(variant);
    view.summaries.push_back(level.summarise(variant, balls, name == s.variant ? &view : nullptr));
    view.summaries.back().ball_radius = balls[view.ball].radius;
  }
  return view;
}

}  // namespace refitlab
