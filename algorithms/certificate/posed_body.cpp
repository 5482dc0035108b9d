// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/posed_body.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

PosedBody posed_body(ClusterBody& body, const std::string& name) {
  const DefaultFloatEnvironment environment;
  const SkinnedMesh& mesh = body.tree().character().mesh;
  PosedBody out{name, mesh.vertices, mesh.triangles};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TrianglePoints vertices = body.triangle(static_cast<int>(t));
    for (int i = 0; i < 3; ++i) out.vertices[mesh.triangles[t][i]] = vertices[i];
  }
  return out;
}

}  // namespace refitlab
