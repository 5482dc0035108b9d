// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/body.hpp"

#include <new>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {

void Body::begin(const Pose& pose, const Deformation& deformation) try {
  const DefaultFloatEnvironment environment;
  check_pose(character_.mesh, pose);  // so that the frame before goes on if one of both is refused
  deform(deformation);
  palette_packs_.make(pose, palette_);
  palette_.measure();
  start();
} catch (const std::bad_alloc&) {
  lose_frame();
  throw;
}

void Body::begin(const AffinePose& pose, const std::vector<double>& weights) try {
  if (skinning_ != Skinning::linear) {
    const auto [rigid, scales] = split(character_.mesh, pose);
    return begin(rigid, {weights, scales});
  }
  const DefaultFloatEnvironment environment;
  check_pose(character_.mesh, pose);
  deform({weights, {}});
  make_skinning_palette(character_.mesh, character_.sets, pose, palette_);
  start();
} catch (const std::bad_alloc&) {
  lose_frame();
  throw;
}

void Body::deform(const Deformation& deformation) {
  if (!deformation.is_none()) {
    if (!reference_) reference_.emplace(character_, pieces_);
    reference_->begin(deformation);
  }
  is_deformed_ = !deformation.is_none();
}

void Body::start() {
  balls_.begin(palette_, is_deformed_ ? &*reference_ : nullptr);
  vertices_skinned_ = 0;
  made_.begin();
}

// Some of what belongs to a frame is that of the next one already.
void Body::lose_frame() {
  balls_.end();
  made_.begin();
}

TrianglePoints Body::triangle(int triangle) {
  const Triangle& t = character_.mesh.triangles[triangle];
  return {vertex(t[0]), vertex(t[1]), vertex(t[2])};
}

const Point3& Body::vertex(int v) {
  const DefaultFloatEnvironment environment;
  if (!made_.is_made(v)) {
    balls_.require_frame();
    skinned_[v] = blend<double>(skinning_, palette_[character_.sets.of_vertex(v)], character_.sets.weights(v),
                                is_deformed_ ? reference_->vertex(v) : character_.mesh.vertices[v]);
    made_.mark(v);
    ++vertices_skinned_;
  }
  return skinned_[v];
}

}  // namespace refitlab
