// SPDX-License-Identifier: MIT
#include "algorithms/methods/refit/bd_tree.hpp"

#include "algorithms/runtime/balls/mean_ball.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Returns the displacements of all of these vertices, by target. A vertex that a target does not move has the displacement 0.
std::vector<std::vector<Point3>> displacements_of(const SkinnedMesh& mesh, std::span<const int> vertices) {
  const auto targets = static_cast<std::size_t>(mesh.targets.count);
  std::vector<std::vector<Point3>> out(targets, std::vector<Point3>(vertices.size(), Point3::Zero()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (const Displacement<double>& d : mesh.displacements(vertices[i])) out[static_cast<std::size_t>(d.target)][i] = d.by;
  return out;
}

}  // namespace

Character bd_tree(const Character& character) {
  const DefaultFloatEnvironment environment;
  Character out = character;
  out.pieces = {};
  DisplacementTable& table = out.tree.displacements;
  table = {};
  if (character.mesh.targets.count == 0) return out;
  for (int n = 0; n < static_cast<int>(character.tree.nodes.size()); ++n) {
    table.first.push_back(table.balls.size());
    const auto by_target = displacements_of(character.mesh, character.vertices[n]);
    for (std::size_t k = 0; k < by_target.size(); ++k)
      table.balls.push_back({static_cast<int>(k), rounded_up(mean_ball<double, 3>(by_target[k]))});
  }
  table.first.push_back(table.balls.size());
  return out;
}

}  // namespace refitlab
