// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/character_scene.hpp"

namespace refitlab {

std::vector<int> levels_there(const SphereTree& tree, const std::vector<int>& wanted) {
  std::vector<int> levels;
  for (const int level : wanted)
    if (level <= tree.level_count()) levels.push_back(level);
  if (levels.empty()) levels.push_back(tree.level_count());
  return levels;
}

render::MeshShape skin_shape(const SkinnedMesh& model, std::vector<Point3> vertices) {
  render::MeshShape mesh;
  mesh.vertices = std::move(vertices);
  mesh.triangles = model.triangles;
  return mesh;
}

void mark_vertices(render::Scene& scene, const std::vector<Point3>& vertices, const std::vector<bool>& marked,
                   render::Color color, double picture_size) {
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (marked[v]) scene.balls.push_back({{vertices[v], 0.006 * picture_size}, color, 1});
}

std::vector<PictureNumber> counts_of(std::size_t balls, const Misses& misses) {
  return {{"balls", static_cast<double>(balls)},
          {"balls_that_miss", static_cast<double>(misses.ball_count())},
          {"balls_undefined", static_cast<double>(misses.undefined)}};
}

}  // namespace refitlab
