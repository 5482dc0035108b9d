// SPDX-License-Identifier: MIT
// Character: a skinned mesh with all that was made from it before any pose, as algorithms/bake makes it.
#pragma once

#include <array>

#include "algorithms/runtime/tree/piece_table.hpp"

namespace refitlab {

struct Character {
  SkinnedMesh mesh;
  JointSets sets;         // of mesh
  SphereTree tree;        // of mesh and sets
  NodeVertices vertices;  // of tree
  std::array<PieceTable, piece_kinds> pieces;

  bool has(Pieces kind) const { return kind == Pieces::node || !pieces[static_cast<std::size_t>(kind)].first.empty(); }

  // What a variant looks at to refit a node. palette is of make_skinning_palette for this mesh. Throws std::invalid_argument for
  // pieces that the character was made without.
  RefitNode<double> refit_node(int node, const SkinningPalette<double>& palette, Pieces kind) const;
};

}  // namespace refitlab
