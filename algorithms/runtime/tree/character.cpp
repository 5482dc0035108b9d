// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/character.hpp"

#include <stdexcept>

namespace refitlab {

RefitNode<double> Character::refit_node(int node, const SkinningPalette<double>& palette, Pieces kind) const {
  if (kind == Pieces::node) return tree.refit_node(node, palette);
  if (!has(kind)) throw std::invalid_argument(mesh.name + ": baked without the pieces that the refit needs");
  return pieces[static_cast<std::size_t>(kind)].refit_node(tree, node, palette);
}

}  // namespace refitlab
