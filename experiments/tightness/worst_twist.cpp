// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/tightness/worst_twist.hpp"

#include <numbers>
#include <tuple>

#include "algorithms/bake/parallel.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/tightness/misses.hpp"

namespace refitlab {
namespace {

// Returns how many balls of all nodes are defined and yet have a vertex outside.
long count_misses(const AnimatedCharacter& c, std::span<const int> nodes, const Pose& pose, const RefitVariant& variant) {
  const auto palette = make_skinning_palette(c.mesh, c.sets, pose, variant.skinning);
  const auto misses = find_misses(c, nodes, refit_all(c, variant, palette), skin(c.mesh, c.sets, palette, variant.skinning));
  return misses.ball_count() - misses.undefined;
}

}  // namespace

NamedPose worst_twist(const AnimatedCharacter& c) {
  struct {
    long misses = -1;
    int joint = 0, degrees = 0;
  } worst;
  std::mutex guard;
  const auto nodes = nodes_of_level(c.tree, 0);
  const int angles[] = {90, 120, 150, 175};
  const RefitVariant& printed = compared_variant("spherical_printed_signed");
  parallel_for(c.mesh.joints.size() * std::size(angles), [&](std::size_t i) {
    const int joint = static_cast<int>(i / std::size(angles)), degrees = angles[i % std::size(angles)];
    const Pose pose = twist_pose(c.mesh, joint, degrees * std::numbers::pi / 180);
    const long misses = count_misses(c, nodes, pose, printed);
    const std::lock_guard lock(guard);
    if (std::tuple(misses, -joint, -degrees) > std::tuple(worst.misses, -worst.joint, -worst.degrees))
      worst = {misses, joint, degrees};
  });
  return {"worst twist: " + c.mesh.joints[worst.joint].name + " by " + std::to_string(worst.degrees) + " degrees",
          twist_pose(c.mesh, worst.joint, worst.degrees * std::numbers::pi / 180), "worst_twist"};
}

}  // namespace refitlab
