// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/bake.hpp"

#include <utility>

#include "algorithms/bake/build_displacements.hpp"
#include "algorithms/bake/build_pieces.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

PieceOptions options_of(Pieces kind, Joints joints, bool has_targets) {
  const bool deforms = has_targets || joints == Joints::affine;
  PieceOptions out;
  if (kind == Pieces::mixed)
    out = {.pieces_per_joint_set = 4. / 3, .vertices_per_control_point = 2, .most_displaced_vertices = 64};
  if (kind == Pieces::many) out = {.most_pieces = many_pieces};
  if (kind == Pieces::many && deforms) out.pieces_per_joint_set = 4, out.weight_extent = 0.25, out.most_displaced_vertices = 64;
  if (kind != Pieces::joint_sets && joints == Joints::affine) out.most_stretched_vertices = 32, out.stretched_pieces = 16;
  return out;
}

}  // namespace

Character bake(SkinnedMesh mesh, const TreeOptions& options, std::initializer_list<Pieces> pieces, Joints joints) {
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
      c.pieces[static_cast<std::size_t>(kind)] =
          build_pieces(c.tree, c.vertices, c.mesh, c.sets, options_of(kind, joints, c.mesh.targets.count > 0));
  return c;
}

Character bake(Model model, const TreeOptions& options, std::initializer_list<Pieces> pieces) {
  const Joints joints = joints_of(model);
  return bake(std::move(model), options, pieces, joints);
}

Character bake(Model model, const TreeOptions& options, std::initializer_list<Pieces> pieces, Joints joints) {
  return bake(skinned_mesh(std::move(model)), options, pieces, joints);
}

}  // namespace refitlab
