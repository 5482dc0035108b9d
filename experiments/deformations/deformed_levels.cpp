// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/deformed_levels.hpp"

#include "algorithms/bake/parallel.hpp"
#include "algorithms/methods/refit/deformed.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/tightness/add_balls.hpp"

namespace refitlab {
namespace {

using Levels = std::vector<LevelTightness>;

std::vector<Levels> levels_in_pose(const Character& c, std::span<const RefitVariant* const> variants, const DeformedPose& pose) {
  const Skinning skinning = variants[0]->skinning;
  const DeformedFrame now = frame_of(c, pose, skinning);
  const auto skinned = skin(c.mesh, c.sets, now.palette, skinning, now.deformation);
  const auto optimal = optimal_balls(c.tree, c.vertices, skinned);
  std::vector<Levels> out;
  for (const RefitVariant* variant : variants) {
    DeformedReference reference(c, variant->pieces);
    reference.begin(now.deformation);
    FrameRefits frame(c, *variant);
    frame.begin(now.palette, &reference);
    std::vector<Ball3<double>> balls;
    for (std::size_t n = 0; n < optimal.size(); ++n) balls.push_back(frame[static_cast<int>(n)]);
    add_balls(c, balls, optimal, skinned, variant->sound, out.emplace_back());
  }
  return out;
}

}  // namespace

std::vector<Levels> deformed_levels(const Character& c, std::span<const RefitVariant* const> variants,
                                    std::span<const DeformedPose> poses) {
  std::vector<std::vector<Levels>> parts(poses.size());
  parallel_for(poses.size(), [&](std::size_t i) { parts[i] = levels_in_pose(c, variants, poses[i]); });
  std::vector<Levels> total(variants.size(), Levels(static_cast<std::size_t>(c.tree.level_count())));
  for (const auto& part : parts)  // in order, so that sums do not depend on the threads
    for (std::size_t v = 0; v < total.size(); ++v)
      for (std::size_t l = 0; l < total[v].size(); ++l) total[v][l].merge(part[v][l]);
  return total;
}

WorstLevel worst_level(std::span<const LevelTightness> levels) {
  WorstLevel worst;
  for (std::size_t l = 0; l < levels.size(); ++l)
    if (const double ratio = levels[l].ratio_to_optimal(); ratio > worst.ratio) worst = {ratio, static_cast<int>(l) + 1};
  return worst;
}

long all_misses(std::span<const LevelTightness> levels) {
  long out = 0;
  for (const LevelTightness& level : levels) out += level.misses;
  return out;
}

}  // namespace refitlab
