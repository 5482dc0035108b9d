// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/reduced_measures.hpp"

#include <iostream>

#include "algorithms/methods/refit/bd_tree.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/deformations/deformed_levels.hpp"
#include "experiments/deformations/deforming.hpp"
#include "experiments/deformations/reduced_basis.hpp"
#include "experiments/deformations/vibration.hpp"

namespace refitlab {
namespace {

using Frames = std::vector<std::vector<Point3>>;  // displacements by frame and vertex

// Returns the displacements of the first clip's skinned vertices from the reference pose.
Frames clip_frames(const Model& model, int count) {
  const JointSets sets(model);
  const Clip& clip = model.clips.at(0);
  Frames out;
  for (const double share : even_shares(count)) {
    const Pose pose = clip.sample(share * clip.duration);
    const auto palette = make_skinning_palette(model, sets, pose, Skinning::spherical);
    out.push_back(skin(model, sets, palette, Skinning::spherical));
    for (std::size_t v = 0; v < out.back().size(); ++v) out.back()[v] -= model.vertices[v];
  }
  return out;
}

ReducedCharacter with_basis(const Model& model, ReducedBasis basis) {
  SkinnedMesh mesh = model;
  mesh.targets = basis.targets;
  Character ours = bake(std::move(mesh), {}, {Pieces::mixed, Pieces::many}), theirs = bd_tree(ours);
  return {std::move(basis), std::move(ours), std::move(theirs)};
}

class ReducedExperiment {
 public:
  ReducedExperiment(const Model& model, const ReducedSettings& settings) : model_(model), settings_(settings) {}

  void measure(const std::string& kind, const ReducedCharacter& character, bool is_skinned) {
    const ReducedBasis& basis = character.basis;
    const Character &ours = character.ours, &theirs = character.bd_tree;
    const auto poses = poses_of(basis, false);
    results_.push_back({kind, settings_.frames, settings_.size, basis.share, static_cast<int>(poses.size()), {}});
    measure(theirs, DisplacementBalls::bd_tree, {&reference_balls()}, poses);
    measure(ours, DisplacementBalls::smallest, {&reference_balls()}, poses);
    measure(ours, DisplacementBalls::smallest, {&refit_variant("control_mixed"), &refit_variant("control_many_pieces")}, poses);
    if (!is_skinned) return;
    const auto moving = poses_of(basis, true);
    results_.push_back({kind + "_skinned", settings_.frames, settings_.size, basis.share, static_cast<int>(moving.size()), {}});
    const RefitVariant &repaired = refit_variant("spherical_repaired"), &control = refit_variant("control_miniball");
    measure(theirs, DisplacementBalls::bd_tree, {&repaired, &control}, moving);
    measure(ours, DisplacementBalls::smallest, {&repaired, &control}, moving);
    measure(ours, DisplacementBalls::smallest, {&refit_variant("control_mixed"), &refit_variant("control_many_pieces")}, moving);
  }

  std::vector<ReducedResult> results() { return std::move(results_); }

 private:
  // Returns frames of the basis, in the reference pose, or each at a time of the first clip.
  std::vector<DeformedPose> poses_of(const ReducedBasis& basis, bool moves) const {
    std::vector<DeformedPose> out;
    for (const double share : even_shares(settings_.poses)) {
      const auto frame = static_cast<std::size_t>(share * static_cast<double>(basis.coordinates.size()));
      const Clip& clip = model_.clips.at(0);
      out.push_back({moves ? clip.sample(share * clip.duration) : reference_pose(model_), {}, {}, basis.coordinates[frame]});
    }
    return out;
  }

  void measure(const Character& c, DisplacementBalls balls, const std::vector<const RefitVariant*>& variants,
               const std::vector<DeformedPose>& poses) {
    auto levels = deformed_levels(c, variants, poses);
    for (std::size_t v = 0; v < variants.size(); ++v) {
      const WorstLevel worst = worst_level(levels[v]);
      std::cout << "  " << results_.back().kind << ", " << variants[v]->name << ", "
                << (balls == DisplacementBalls::bd_tree ? "BD-tree's" : "smallest") << " balls of displacements: at most "
                << worst.ratio << " of the smallest (level " << worst.level << "), misses " << all_misses(levels[v]) << std::endl;
      results_.back().measures.push_back({variants[v]->name, balls, std::move(levels[v])});
    }
  }

  const Model& model_;
  const ReducedSettings& settings_;
  std::vector<ReducedResult> results_;
};

}  // namespace

const RefitVariant& reference_balls() {
  static const auto reference = [](const RefitNode<double>& node) { return node.reference; };
  static const RefitVariant variant{
      "reference_balls", "the deformed ball of the reference pose", Skinning::linear, true, Pieces::node, reference, reference};
  return variant;
}

ReducedCharacter vibrating_character(const Model& model, const ReducedSettings& settings) {
  return with_basis(model, reduced_basis(vibration(model, settings.frames), settings.size));
}

std::vector<ReducedResult> measure_reduced(const Model& model, const ReducedSettings& settings) {
  ReducedExperiment experiment(model, settings);
  experiment.measure("vibration", vibrating_character(model, settings), true);
  experiment.measure("clip", with_basis(model, reduced_basis(clip_frames(model, settings.frames), settings.size)), false);
  return experiment.results();
}

}  // namespace refitlab
