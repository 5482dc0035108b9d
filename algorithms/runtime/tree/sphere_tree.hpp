// SPDX-License-Identifier: MIT
// A SphereTree has the bounding spheres of a skinned mesh in the reference pose, as algorithms/bake/build_tree makes them (paper
// 3 and 4.1).
//
// The arrays are flat. Nodes are level by level from the root (level 1, as in the paper's Table 1), with the children of a
// node side by side. Every triangle lies whole in one leaf, and the children of a node together hold the same triangles as
// the node.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/tree/displacement_table.hpp"
#include "algorithms/runtime/tree/refit_node.hpp"

namespace refitlab {

struct TreeNode {
  Ball3<double> reference;               // the smallest ball of its vertices in the reference pose
  int parent, first_child, child_count;  // parent is -1 at the root, child_count 0 at a leaf
  int level;
  int first_triangle, triangle_count;  // in SphereTree::triangle_order
  int first_vertex, vertex_count;      // in SphereTree::leaf_vertices; 0 except at leaves
  int first_piece, piece_count;        // in SphereTree::pieces
};

struct SphereTree {
  std::vector<TreeNode> nodes;
  std::vector<int> triangle_order;
  std::vector<int> leaf_vertices;
  std::vector<NodePiece> pieces;
  std::vector<double> weight_vertices;
  DisplacementTable displacements = {};  // of the nodes' vertices

  int level_count() const { return nodes.back().level; }
  RefitNode<double> refit_node(int node, const SkinningPalette<double>& palette) const {
    const TreeNode& n = nodes[node];
    return {
        n.reference, {pieces.data() + n.first_piece, static_cast<std::size_t>(n.piece_count)}, weight_vertices.data(), palette};
  }
};

// Returns the distinct vertices of some triangles, in increasing order.
std::vector<int> distinct_vertices(const SkinnedMesh& mesh, std::span<const int> triangles);

// NodeVertices has the distinct vertices of each node's triangles, in increasing order. Refitting never uses them; code that
// checks or measures a refit does.
class NodeVertices {
 public:
  NodeVertices(const SphereTree& tree, const SkinnedMesh& mesh);
  std::span<const int> operator[](int node) const { return {vertices_.data() + first_[node], first_[node + 1] - first_[node]}; }

 private:
  std::vector<std::size_t> first_;
  std::vector<int> vertices_;
};

}  // namespace refitlab
