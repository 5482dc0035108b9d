// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/half_turns.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

std::vector<std::string> half_turns(const Model& model) {
  const DefaultFloatEnvironment environment;
  std::vector<std::string> out;
  for (const Clip& clip : model.clips)
    for (const NodeTrack& track : clip.animation.tracks) {
      if (track.rotations.interpolation != Interpolation::linear) continue;
      const auto& keys = track.rotations.keys;
      const auto found = std::adjacent_find(keys.begin(), keys.end(), [](const auto& a, const auto& b) {
        return a.time < b.time && std::abs(a.value.coeffs().dot(b.value.coeffs())) <= rounding_of_cosine_in_float;
      });
      if (found == keys.end()) continue;
      const auto k = found - keys.begin();
      out.push_back("clip '" + clip.name + "', joint '" + model.skeleton.nodes[track.node].name + "', keys " + std::to_string(k) +
                    " and " + std::to_string(k + 1) +
                    ": are half a turn apart, and a renderer in float may turn the other way than the bounds");
    }
  return out;
}

}  // namespace refitlab
