// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/body.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {

void Body::begin(const Pose& pose) {
  const DefaultFloatEnvironment environment;
  palette_packs_.make(pose, palette_);
  palette_.measure();
  balls_.begin(palette_);
  vertices_skinned_ = 0;
  made_.begin();
}

TrianglePoints Body::triangle(int triangle) {
  const Triangle& t = character_.mesh.triangles[triangle];
  return {vertex(t[0]), vertex(t[1]), vertex(t[2])};
}

const Point3& Body::vertex(int v) {
  const DefaultFloatEnvironment environment;
  if (!made_.is_made(v)) {
    skinned_[v] =
        blend<double>(skinning_, palette_[character_.sets.of_vertex(v)], character_.sets.weights(v), character_.mesh.vertices[v]);
    made_.mark(v);
    ++vertices_skinned_;
  }
  return skinned_[v];
}

}  // namespace refitlab
