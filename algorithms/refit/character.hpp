// Character: a model with all that is built once from it, before any posture.
#pragma once

#include <memory>

#include "algorithms/refit/lazy_piece_tables.hpp"

namespace refitlab {

struct Character {
  // m is valid (see Model). Takes some ten microseconds a triangle.
  explicit Character(Model m, const TreeOptions& options = {});

  // What a variant looks at to refit a node. pose is of make_skinning_pose for this model.
  RefitNode<double> refit_node(int node, const SkinningPose<double>& pose, Pieces kind) const;

  // Makes what refit_node needs for this kind of pieces; else the first call does, which takes longer than the tree.
  void prepare(Pieces kind) const;

  // The balls of all nodes.
  std::vector<Ball3<double>> refit_all(const RefitVariant& variant, const SkinningPose<double>& pose) const;

  Model model;
  JointSets sets;
  SphereTree tree;
  NodeVertices vertices;

 private:
  const PieceTable& pieces(Pieces kind) const;

  std::shared_ptr<LazyPieceTables> tables_ = std::make_shared<LazyPieceTables>();  // of copies too: they are the same
};

}  // namespace refitlab
