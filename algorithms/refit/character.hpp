// Character: a model with all that is built once from it, before any posture.
#pragma once

#include "algorithms/refit/variants.hpp"
#include "algorithms/tree/pieces.hpp"

namespace refitlab {

struct Character {
  // m is valid (see Model). Takes some ten microseconds a triangle.
  explicit Character(Model m, const TreeOptions& options = {});

  // What a variant looks at to refit a node. pose is of make_skinning_pose for this model.
  RefitNode<double> refit_node(int node, const SkinningPose<double>& pose, Pieces pieces) const;

  // The balls of all nodes.
  std::vector<Ball3<double>> refit_all(const RefitVariant& variant, const SkinningPose<double>& pose) const;

  Model model;
  JointSets sets;
  SphereTree tree;
  NodeVertices vertices;
  PieceTable joint_set_pieces, mixed_pieces, clusters;  // by kind of Pieces
};

}  // namespace refitlab
