// SPDX-License-Identifier: GPL-3.0-or-later
// An AnimatedCharacter is a baked character with the clips of the model that it was made from.
#pragma once

#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/bake/bake.hpp"

namespace refitlab {

struct AnimatedCharacter : Character {
  std::vector<Clip> clips;
};

// Does what bake() does. joints are those of the clips (joints_of) if they are not given.
inline AnimatedCharacter bake_animated(Model model, const TreeOptions& tree = {},
                                       std::initializer_list<Pieces> pieces = all_pieces, std::optional<Joints> joints = {}) {
  if (!joints) joints = joints_of(model);
  std::vector<Clip> clips = std::move(model.clips);
  return {bake(std::move(model), tree, pieces, *joints), std::move(clips)};
}

}  // namespace refitlab
