// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/bake.hpp"

#include <utility>

#include "algorithms/bake/build_displacements.hpp"
#include "algorithms/bake/build_pieces.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

PieceOptions options_of(Pieces kind) {
  switch (kind) {
    case Pieces::mixed: return {.pieces_per_joint_set = 4. / 3, .vertices_per_control_point = 2, .most_displaced_vertices = 64};
    case Pieces::many: return {.most_pieces = many_pieces};
    default: return {};
  }
}

}  // namespace

Character bake(SkinnedMesh mesh, const TreeOptions& options, std::initializer_list<Pieces> pieces) {
  const DefaultFloatEnvironment environment;
  const JointSets sets(mesh);
  SphereTree tree = build_sphere_tree(mesh, sets, options);
  NodeVertices vertices(tree, mesh);
  if (mesh.targets.count > 0) {
    std::vector<std::vector<int>> lists;
    for (int n = 0; n < static_cast<int>(tree.nodes.size()); ++n) lists.emplace_back(vertices[n].begin(), vertices[n].end());
    tree.displacements = build_displacements(mesh, lists);
  }
  Character c{std::move(mesh), sets, std::move(tree), std::move(vertices), {}};
  for (const Pieces kind : pieces)
    if (kind != Pieces::node)
      c.pieces[static_cast<std::size_t>(kind)] = build_pieces(c.tree, c.vertices, c.mesh, c.sets, options_of(kind));
  return c;
}

AnimatedCharacter bake(Model model, const TreeOptions& options, std::initializer_list<Pieces> pieces) {
  std::vector<Clip> clips = std::move(model.clips);
  if (!model.morphs.empty()) model.targets = morph_targets(model);
  return {bake(SkinnedMesh(std::move(model)), options, pieces), std::move(clips)};
}

}  // namespace refitlab
