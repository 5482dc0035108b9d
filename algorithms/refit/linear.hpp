// Refitting for linear blend skinning [Kavan and Zara 2005a]: the balls whose centers are the corner-blended images of
// the reference ball's center, all of its radius, and one ball around them.
#pragma once

#include "algorithms/refit/ball_policy.hpp"
#include "algorithms/refit/refit_node.hpp"
#include "algorithms/skinning/blend.hpp"

namespace refitlab {

// Encloses the node's vertices under linear blending: a convex combination of rigid images of S lies in the ball of the
// same radius about the same combination of the images of its center.
template <class Policy, class S>
Ball3<S> refit_linear(const RefitNode<S>& node, RefitLists<S>& lists) {
  lists.balls.clear();
  for (std::size_t i = 0; i < node.joint_sets.size(); ++i) {
    const NodeJointSet& set = node.joint_sets[i];
    const Ball3<S>& reference = node.piece_reference(i);
    for (int k = 0; k < set.corner_count; ++k)
      lists.balls.push_back({blend_linear(node.pose[set.joint_set], node.corner(set, k), reference.center), reference.radius});
  }
  return Policy::of_balls(std::span<const Ball3<S>>(lists.balls));
}

}  // namespace refitlab
