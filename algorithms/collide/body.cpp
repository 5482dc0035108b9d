#include "algorithms/collide/body.hpp"

#include <algorithm>

#include "algorithms/skinning/blend.hpp"

namespace refitlab {

void Body::begin(const Posture& posture) {
  pose_ = make_skinning_pose(character_.model, character_.sets, posture, skinning_);
  balls_.begin(pose_);
  vertices_skinned_ = 0;
  if (++frame_ == 0) {  // the counter went round
    std::fill(frame_of_.begin(), frame_of_.end(), 0);
    frame_ = 1;
  }
}

TrianglePoints Body::triangle(int triangle) {
  const Triangle& t = character_.model.triangles[triangle];
  return {vertex(t[0]), vertex(t[1]), vertex(t[2])};
}

const Point3& Body::vertex(int v) {
  if (frame_of_[v] != frame_) {
    skinned_[v] = blend<double>(skinning_, pose_[character_.sets.of_vertex(v)], character_.sets.weights(v),
                                character_.model.vertices[v]);
    frame_of_[v] = frame_;
    ++vertices_skinned_;
  }
  return skinned_[v];
}

}  // namespace refitlab
