// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/longest_chain.hpp"

#include "algorithms/runtime/refit/algorithm1_repaired.hpp"
#include "algorithms/runtime/refit/refit_linear.hpp"
#include "algorithms/runtime/skinning/convert_palette.hpp"

namespace refitlab {

double longest_chain(const SphereTree& tree, const SkinningPalette<double>& palette, bool is_linear, const Latencies& latencies) {
  Chained::latencies = latencies;
  SkinningPalette<Chained> chained;
  for (std::size_t set = 0; set < palette.size(); ++set) {
    const OwnedPaletteEntry<Chained> entry = convert<Chained>(palette[set]);
    chained.push_back(entry);
  }
  const std::vector<Chained> weights(tree.weight_vertices.begin(), tree.weight_vertices.end());
  RefitLists<Chained> lists;
  ControlLists<Chained> control_lists;
  double sum = 0;
  for (const TreeNode& n : tree.nodes) {
    const RefitNode<Chained> node{{convert<Chained>(n.reference.center), n.reference.radius},
                                  {tree.pieces.data() + n.first_piece, static_cast<std::size_t>(n.piece_count)},
                                  weights.data(),
                                  chained};
    const Ball3<Chained> ball =
        is_linear ? refit_linear<MeanBalls>(node, control_lists) : refit_algorithm1_repaired<MeanBalls>(node, lists);
    double ready = ball.radius.ready;
    for (int i = 0; i < 3; ++i) ready = std::max(ready, ball.center[i].ready);
    sum += ready;
  }
  return sum / static_cast<double>(tree.nodes.size());
}

}  // namespace refitlab
