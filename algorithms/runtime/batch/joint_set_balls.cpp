// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/joint_set_balls.hpp"

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

std::vector<Ball3<double>> joint_set_balls(const SkinnedMesh& mesh, const JointSets& sets) {
  const DefaultFloatEnvironment environment;
  std::vector<Box<double>> boxes(sets.count(), Box<double>::empty());
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (int v = 0; v < vertices; ++v) boxes[sets.of_vertex(v)].merge(mesh.vertices[v]);
  std::vector<Ball3<double>> balls;
  for (const Box<double>& b : boxes) balls.push_back({b.center(), 0});
  for (int v = 0; v < vertices; ++v) {
    Ball3<double>& ball = balls[sets.of_vertex(v)];
    ball.radius = max_of(ball.radius, norm<double, 3>(mesh.vertices[v] - ball.center));
  }
  return balls;
}

}  // namespace refitlab
