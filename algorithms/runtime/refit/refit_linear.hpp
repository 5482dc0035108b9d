// SPDX-License-Identifier: MIT
// Refits for linear blend skinning [Kavan and Zara 2005a]. The control balls, of degree 1, are copies of the reference ball.
// Their centers are the images of its center, blended with the weights of each weight vertex. The refit is one ball around them.
// Affine joints stretch the radii (a1_affine_image).
#pragma once

#include "algorithms/runtime/refit/control_lists.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/tree/refit_node.hpp"
#include "lemmas/a1_affine_image.hpp"

namespace refitlab {

// Returns the radius of the control ball at weights w. The radius of a vertex stays 0.
template <class S>
S stretched_radius(const PaletteEntry<S>& palette, std::span<const S> w, const S& radius) {
  if (palette.maps.empty() || radius == S(0)) return radius;
  return root(blended_squared_stretch(palette.maps, palette.stretches, w)) * radius;
}

// Appends the control balls of a node's pieces. Rigid joints are known to have no maps before the first weight vertex.
template <bool is_affine, class S>
void add_control_balls_linear(const RefitNode<S>& node, ControlLists<S>& lists) {
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    const NodePiece& set = node.pieces[i];
    PaletteEntry<S> palette = node.palette[set.joint_set];
    if constexpr (!is_affine) palette.maps = {};
    const Ball3<S>& reference = node.piece_reference(i);
    for (int k = 0; k < set.weight_vertex_count; ++k) {
      const std::span<const S> w = node.weight_vertex(set, k);
      lists.cap.balls.push_back({blend_linear(palette, w, reference.center), stretched_radius(palette, w, reference.radius)});
    }
  }
}

// Makes balls in lists.cap.balls, whose convex hull contains the node's vertices under linear blending. The reason: a
// convex combination of rigid images of S lies in the ball of the same radius about the same combination of the images of
// its center. So does a combination of affine images, for a stretched radius.
template <class S>
std::span<const Ball3<S>> control_balls_linear(const RefitNode<S>& node, ControlLists<S>& lists) {
  lists.cap.balls.clear();
  if (node.palette.is_affine()) add_control_balls_linear<true>(node, lists);
  else add_control_balls_linear<false>(node, lists);
  return lists.cap.balls;
}

// Returns one ball around the control balls.
template <class Policy, class S>
Ball3<S> refit_linear(const RefitNode<S>& node, ControlLists<S>& lists) {
  return Policy::of_balls(control_balls_linear(node, lists));
}

}  // namespace refitlab
