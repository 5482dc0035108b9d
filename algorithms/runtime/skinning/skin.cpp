// SPDX-License-Identifier: MIT
#include "algorithms/runtime/skinning/skin.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {

std::vector<Point3> skin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPalette<double>& palette,
                         Skinning skinning) {
  const DefaultFloatEnvironment environment;
  std::vector<Point3> out;
  out.reserve(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const int v = static_cast<int>(i);
    out.push_back(blend<double>(skinning, palette[sets.of_vertex(v)], sets.weights(v), mesh.vertices[i]));
  }
  return out;
}

}  // namespace refitlab
