// SPDX-License-Identifier: MIT
// The certified ball of a node is the computed ball of a refit, with a slack for all rounding. The slack is derived in
// algorithms/runtime/skinning/palette_rounding.hpp.
#pragma once

#include <limits>

#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/tree/refit_node.hpp"

namespace refitlab {

// Returns how far vertices of the node may be outside the hull of the control balls of its pieces, all computed in S. This
// holds for vertices skinned exactly and for those of skin(). For Skinning::hejl, which bounds as
// spherical skinning does, skinning is Skinning::spherical.
template <Skinning skinning, class S>
S rounding_of_pieces(const RefitNode<S>& node) {
  const Vec<S, 3>& p = node.reference.center;
  const S twice_r = S(2) * node.reference.radius, length = upper_norm(p);
  S worst(0);
  for (const NodePiece& set : node.pieces) {
    const PaletteRounding<S>& rounding = node.palette.rounding(set.joint_set, skinning);
    const RoundingRates<S>& rates = node.is_vertex(set) ? rounding.vertex : rounding.weight_vertices;
    const S reach = twice_r + (skinning == Skinning::spherical ? upper_norm<S>(p - node.palette.rotation_center(set.joint_set))
                                                               : length);  // at least ||x|| + r of the piece
    const S off(rates.per_length * reach + rates.per_radius * node.reference.radius + rates.offset);
    if (!(off <= std::numeric_limits<S>::max())) return std::numeric_limits<S>::infinity();  // of an infinite rate times 0, too
    worst = max_of(worst, off);
  }
  return worst;
}

// ball is the ball that a refit computed for the node. The result encloses the node's vertices, skinned exactly or in S.
template <Skinning skinning, class S>
Ball3<S> certified(const Ball3<S>& ball, const RefitNode<S>& node) {
  return rounded_up(inflate(ball, rounding_of_pieces<skinning>(node)));
}

}  // namespace refitlab
