// SPDX-License-Identifier: MIT
// A node is refitted to any convex volume by putting the volume around the control balls, whose hull holds the node's vertices.
#pragma once

#include <limits>

#include "algorithms/runtime/refit/control_hull.hpp"
#include "algorithms/runtime/refit/rounding.hpp"

namespace refitlab {

// Returns the control balls. In float and double they have a slack for all rounding: their own, and that of a coordinate along a
// direction of a volume, which is off by less than 8 u of the center's length and of the radius.
template <class S>
std::span<const Ball3<S>> certified_control_balls(const RefitNode<S>& node, ControlLists<S>& lists) {
  control_balls(node, lists);
  if constexpr (std::is_floating_point_v<S>) {
    constexpr S u = std::numeric_limits<S>::epsilon() / 2;
    const S rounding = rounding_of_pieces<Skinning::spherical>(node);
    for (Ball3<S>& ball : lists.cap.balls) ball = rounded_up(inflate(ball, S(rounding + 16 * u * upper_norm(ball.center))));
  }
  return lists.cap.balls;
}

// Returns a volume that holds the node's vertices under spherical blending, skinned exactly or in S. Volume::around(balls,
// how...) is a convex volume that encloses the balls.
template <class Volume, class S, class... How>
Volume refit_volume(const RefitNode<S>& node, ControlLists<S>& lists, const How&... how) {
  return Volume::around(certified_control_balls(node, lists), how...);
}

}  // namespace refitlab
