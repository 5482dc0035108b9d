#include "algorithms/refit/character.hpp"

namespace refitlab {
namespace {

PieceOptions options_of(Pieces kind) {
  switch (kind) {
    case Pieces::mixed: return {.pieces_per_joint_set = 4. / 3, .vertices_per_control_point = 2};
    case Pieces::clusters: return {.most_pieces = most_clusters};
    default: return {};
  }
}

}  // namespace

Character::Character(Model m, const TreeOptions& options)
    : model(std::move(m)), sets(model), tree(build_sphere_tree(model, sets, options)), vertices(tree, model) {}

const PieceTable& Character::pieces(Pieces kind) const {
  return tables_->get(kind, [&] { return PieceTable(tree, vertices, model, sets, options_of(kind)); });
}

RefitNode<double> Character::refit_node(int node, const SkinningPose<double>& pose, Pieces kind) const {
  return kind == Pieces::node ? tree.refit_node(node, pose) : pieces(kind).refit_node(tree, node, pose);
}

void Character::prepare(Pieces kind) const {
  if (kind != Pieces::node) pieces(kind);
}

std::vector<Ball3<double>> Character::refit_all(const RefitVariant& variant, const SkinningPose<double>& pose) const {
  std::vector<Ball3<double>> balls;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    balls.push_back(variant.refit(refit_node(static_cast<int>(n), pose, variant.pieces)));
  return balls;
}

}  // namespace refitlab
