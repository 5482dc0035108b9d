// SPDX-License-Identifier: MIT
// A PieceTable describes a node's vertices more tightly than the paper's one ball and one weight box for each joint-set.
//
// A piece consists of some of the node's vertices of one joint-set. It has a reference ball around these vertices alone and
// a polytope that holds their weight vectors. The table is built once, like the tree (algorithms/bake/build_pieces.hpp).
#pragma once

#include <vector>

#include "algorithms/runtime/tree/sphere_tree.hpp"

namespace refitlab {

// Pieces says how finely a node is described, that is, which pieces its RefitNode has.
enum class Pieces {
  node,        // the node's ball and weight boxes, as in the paper (SphereTree::refit_node)
  joint_sets,  // a ball and a weight hull for each joint-set
  mixed,       // the same, or single vertices where that is about as cheap (few vertices, many control points), or where morph
               // targets take vertices apart
  many         // up to 512 pieces a node
};
inline constexpr int piece_kinds = 4;
inline constexpr int many_pieces = 512;

struct PieceTable {
  std::vector<std::size_t> first;  // by node, and one past the last; empty if the character was made without this table
  std::vector<NodePiece> pieces;
  // A vertex that is a piece has one such piece, which all of its nodes share. These pieces come first.
  std::vector<Ball3<double>> references;
  std::vector<double> weight_vertices;
  DisplacementTable displacements = {};  // of the references' vertices

  RefitNode<double> refit_node(const SphereTree& tree, int node, const SkinningPalette<double>& palette) const {
    return {tree.nodes[node].reference,
            {pieces.data() + first[node], first[node + 1] - first[node]},
            weight_vertices.data(),
            palette,
            references};
  }
};

}  // namespace refitlab
