// SPDX-License-Identifier: MIT
// A node is refitted to any convex volume by putting the volume around the control balls, whose hull holds the node's vertices.
#pragma once

#include <limits>

#include "algorithms/runtime/refit/control_hull.hpp"
#include "algorithms/runtime/refit/refit_dual_quaternion.hpp"
#include "algorithms/runtime/refit/refit_linear.hpp"
#include "algorithms/runtime/refit/rounding.hpp"

namespace refitlab {

// Returns the control balls. Of linear skinning joints may be affine. In float and double the balls have a slack for all
// rounding: their own, and that of a coordinate along a direction of a volume, which is off by less than 8 u of the center's
// length and of the radius.
template <Skinning skinning, class S>
std::span<const Ball3<S>> certified_control_balls(const RefitNode<S>& node, ControlLists<S>& lists) {
  static_assert(skinning != Skinning::hejl, "its poses are bounded as spherical");
  if constexpr (skinning == Skinning::linear) control_balls_linear(node, lists);
  else if constexpr (skinning == Skinning::dual_quaternion) control_balls_dual_quaternion(node, lists);
  else control_balls(node, lists);
  if constexpr (std::is_floating_point_v<S>) {
    constexpr S u = std::numeric_limits<S>::epsilon() / 2;
    const S rounding = rounding_of_pieces<skinning>(node);
    for (Ball3<S>& ball : lists.cap.balls) ball = rounded_up(inflate(ball, S(rounding + 16 * u * upper_norm(ball.center))));
  }
  return lists.cap.balls;
}

// Returns a volume that holds the node's vertices, skinned exactly or in S. Volume::around(balls, how...) is a convex volume that
// encloses the balls. If some admissible blend of dual quaternions may be 0, the volume is all of space.
template <class Volume, Skinning skinning, class S, class... How>
Volume refit_volume(const RefitNode<S>& node, ControlLists<S>& lists, const How&... how) {
  return Volume::around(certified_control_balls<skinning>(node, lists), how...);
}

}  // namespace refitlab
