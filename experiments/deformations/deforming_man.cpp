// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/deforming_man.hpp"

#include <cmath>
#include <memory>

#include "algorithms/model/keyed.hpp"
#include "experiments/deformations/deforming.hpp"
#include "experiments/procedural/procedural.hpp"

namespace refitlab {
namespace {

constexpr double keys_per_second = 10;

MorphedMesh morphed_mesh(const MorphTargets& targets) {
  const auto count = static_cast<std::size_t>(targets.count);
  MorphedMesh out{0, std::vector<double>(count, 0.0), std::vector<MorphTarget>(count)};
  for (std::size_t v = 0; v < targets.of_vertex.size(); ++v)
    for (const Displacement<double>& d : targets.of_vertex[v])
      out.targets[static_cast<std::size_t>(d.target)].displacements.emplace_back(static_cast<int>(v), d.by);
  return out;
}

// Returns the scale of a joint relative to its parent. The factors are near 1, since they multiply along a chain.
Eigen::Vector3d scale_at(std::size_t joint, double time) {
  const auto j = static_cast<double>(joint);
  return {1 + 0.10 * std::sin(j + 3 * time), 1 + 0.06 * std::cos(1.7 * j - 2 * time), 1 + 0.08 * std::sin(2.3 * j + time)};
}

Eigen::VectorXd weights_at(int count, double time) {
  Eigen::VectorXd out(count);
  for (int k = 0; k < count; ++k) out[k] = 0.5 + 0.5 * std::sin(k + 2 * time);
  return out;
}

void deform(Animation& animation, int targets) {
  for (std::size_t j = 0; j < animation.tracks.size(); ++j) {
    NodeTrack& track = animation.tracks[j];
    track.scales.keys.clear();
    for (const auto& key : track.positions.keys) track.scales.keys.push_back({key.time, scale_at(j, key.time)});
  }
  WeightTrack weights{0, {}};
  for (const auto& key : animation.tracks[0].positions.keys)
    weights.weights.keys.push_back({key.time, weights_at(targets, key.time)});
  animation.weight_tracks = {std::move(weights)};
}

}  // namespace

Model make_deforming_man() {
  Model man = keyed(make_man(), keys_per_second);
  SkinnedMesh morphed = man;
  add_targets(morphed);
  man.name = "deforming man";
  man.skeleton.file = man.name;
  man.morphs = {morphed_mesh(morphed.targets)};
  const auto skeleton = std::make_shared<const BoundSkeleton>(man.skeleton);
  for (Clip& clip : man.clips) {
    deform(clip.animation, morphed.targets.count);
    const Animation motion = clip.animation;
    clip.sample = [skeleton, motion](double time) { return pose(*skeleton, motion, time).pose; };
  }
  return man;
}

}  // namespace refitlab
