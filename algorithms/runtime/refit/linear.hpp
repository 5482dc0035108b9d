// SPDX-License-Identifier: MIT
// Refitting for linear blend skinning [Kavan and Zara 2005a]: the balls whose centers are the corner-blended images of
// the reference ball's center, all of its radius, and one ball around them. They are the control balls of degree 1.
#pragma once

#include "algorithms/runtime/refit/control_lists.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/tree/refit_node.hpp"

namespace refitlab {

// Balls whose convex hull contains the node's vertices under linear blending, in lists.cap.balls: a convex combination
// of rigid images of S lies in the ball of the same radius about the same combination of the images of its center.
template <class S>
std::span<const Ball3<S>> control_balls_linear(const RefitNode<S>& node, ControlLists<S>& lists) {
  lists.cap.balls.clear();
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    const NodePiece& set = node.pieces[i];
    const PaletteEntry<S> palette = node.palette[set.joint_set];
    const Ball3<S>& reference = node.piece_reference(i);
    for (int k = 0; k < set.weight_vertex_count; ++k)
      lists.cap.balls.push_back({blend_linear(palette, node.corner(set, k), reference.center), reference.radius});
  }
  return lists.cap.balls;
}

// One ball around them.
template <class Policy, class S>
Ball3<S> refit_linear(const RefitNode<S>& node, ControlLists<S>& lists) {
  return Policy::of_balls(control_balls_linear(node, lists));
}

}  // namespace refitlab
