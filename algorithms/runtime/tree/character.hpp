// SPDX-License-Identifier: MIT
// A Character is a skinned mesh with everything that algorithms/bake makes from it before any pose.
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

  // Returns what a variant uses to refit a node. palette must come from make_skinning_palette for this mesh. Throws
  // std::invalid_argument if the character was made without these pieces.
  RefitNode<double> refit_node(int node, const SkinningPalette<double>& palette, Pieces kind) const;
};

}  // namespace refitlab
