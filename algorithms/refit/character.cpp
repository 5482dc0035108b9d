#include "algorithms/refit/character.hpp"

namespace refitlab {

Character::Character(Model m, const TreeOptions& options)
    : model(std::move(m)),
      sets(model),
      tree(build_sphere_tree(model, sets, options)),
      vertices(tree, model),
      joint_set_pieces(tree, vertices, model, sets, {}),
      mixed_pieces(tree, vertices, model, sets, {.pieces_per_joint_set = 4. / 3, .vertices_per_control_point = 2}),
      clusters(tree, vertices, model, sets, {.most_pieces = most_clusters}) {}

RefitNode<double> Character::refit_node(int node, const SkinningPose<double>& pose, Pieces pieces) const {
  switch (pieces) {
    case Pieces::joint_sets: return joint_set_pieces.refit_node(tree, node, pose);
    case Pieces::mixed: return mixed_pieces.refit_node(tree, node, pose);
    case Pieces::clusters: return clusters.refit_node(tree, node, pose);
    default: return tree.refit_node(node, pose);
  }
}

std::vector<Ball3<double>> Character::refit_all(const RefitVariant& variant, const SkinningPose<double>& pose) const {
  std::vector<Ball3<double>> balls;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    balls.push_back(variant.refit(refit_node(static_cast<int>(n), pose, variant.pieces)));
  return balls;
}

}  // namespace refitlab
