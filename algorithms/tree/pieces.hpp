// Pieces: tighter descriptions of what a node holds than the paper's one ball and one weight box a joint-set.
//
// A piece is some of the node's vertices of one joint-set, with a reference ball of these vertices alone and the hull of
// their weight vectors in place of the weight box wherever the hull has no more corners. Built once, like the tree.
#pragma once

#include <vector>

#include "algorithms/tree/sphere_tree.hpp"

namespace refitlab {

struct PieceOptions {
  // A joint-set's vertices are split in two where that makes the pieces smaller, until a node has this many pieces. 1: no
  // splitting, one piece a joint-set.
  int most_pieces = 1;
  // The same for nodes of many joint-sets: this many pieces for each of them, rounded down, if that is more.
  double pieces_per_joint_set = 1;
  // A piece of few vertices is dearer to bound than to skin: one with at most this many vertices for each of its control
  // points (m corners have m(m+1)(m+2)/6) becomes a piece a vertex, a ball of radius 0 with one corner, whose bound is
  // the skinned vertex itself. A node of a single rigid piece stays: it is bounded exactly as it is. 0: never.
  double vertices_per_control_point = 0;
};

class PieceTable {
 public:
  PieceTable(const SphereTree& tree, const NodeVertices& vertices, const Model& model, const JointSets& sets,
             const PieceOptions& options);

  RefitNode<double> refit_node(const SphereTree& tree, int node, const SkinningPose<double>& pose) const {
    const std::size_t first = first_[node], count = first_[node + 1] - first;
    return {tree.nodes[node].reference, {pieces_.data() + first, count}, corner_weights_.data(), pose,
            references_};
  }
  std::size_t piece_count() const { return pieces_.size(); }

 private:
  // Those that touch the smallest ball of all come first, the others stay in order.
  void order_by_support(std::span<NodeJointSet> pieces) const;

  std::vector<std::size_t> first_;  // by node, and one past the last
  std::vector<NodeJointSet> pieces_;
  // Of the pieces of one vertex there is one for each vertex, whatever the nodes it is in: they come first.
  std::vector<Ball3<double>> references_;
  std::vector<double> corner_weights_;
};

}  // namespace refitlab
