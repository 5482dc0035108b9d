// SPDX-License-Identifier: MIT
// This is Algorithm 1, repaired. It is sound for every pose and every weight bound: without exception in intervals and exact
// numbers, and up to rounding in float and double.
//
// It differs from the printed algorithm in four ways. It uses the skinning's own quaternion signs. If a blend may vanish,
// or a cap is a half-sphere or more, it takes all rotations. Beyond 90 degrees, the smallest ball of a cap is that of the
// whole sphere. It computes the angle from its chord.
#pragma once

#include "algorithms/runtime/refit/ball_policy.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/tree/refit_node.hpp"
#include "lemmas/rotation_bound.hpp"

namespace refitlab {

// Bounds the rotations for the weights of a hull (lines 5 to 13). Line 13 is Lemma 4, of the cap about the center of the blends at
// the weight vertices (rotation_bound). If a blend may vanish, the bound allows all rotations. blend(k) returns the blended quaternion
// at weight vertex k.
template <class Policy, class S, class Blend>
RotationBound<S> bound_weight_vertex_rotations(std::size_t weight_vertex_count, const Blend& blend,
                                               std::vector<Quaternion<S>>& unit) {
  unit.clear();
  for (std::size_t k = 0; k < weight_vertex_count; ++k) {
    const Quaternion<S> q = blend(k);
    const S squared_length = squared_norm(q);
    if (!is_certainly_nonzero(squared_length)) return all_rotations<S>();
    unit.push_back(q / root(squared_length));
  }
  const std::span<const Quaternion<S>> points(unit);
  return bound_rotations(points, Policy::template center_of_points<S, 4>(points));
}

// Does the same for the weights of one joint-set of a node.
template <class Policy, class S>
RotationBound<S> bound_joint_set_rotations(const RefitNode<S>& node, const NodePiece& set, std::vector<Quaternion<S>>& unit) {
  const PaletteEntry<S> palette = node.palette[set.joint_set];
  const auto blend = [&](std::size_t k) { return blend_quaternion(palette, node.weight_vertex(set, static_cast<int>(k))); };
  return bound_weight_vertex_rotations<Policy, S>(set.weight_vertex_count, blend, unit);
}

// Returns a ball around the node's vertices as its palette skins them, in model space, without a slack for rounding. Policy makes
// the enclosing balls (ball_policy.hpp). lists is kept between calls.
template <class Policy, class S>
Ball3<S> refit_algorithm1_repaired(const RefitNode<S>& node, RefitLists<S>& lists) {
  lists.balls.clear();
  for (const NodePiece& set : node.pieces) {
    const PaletteEntry<S> palette = node.palette[set.joint_set];
    const RotationBound<S> bound = bound_joint_set_rotations<Policy>(node, set, lists.quaternions);
    const Vec<S, 3> u = node.reference.center - palette.rotation_center;
    const Ball3<S> turned = rotated_ball(bound, u);  // line 14, and line 15: Lemma 5, repaired
    for (int k = 0; k < set.weight_vertex_count; ++k)
      lists.balls.push_back({blend_center(palette, node.weight_vertex(set, k)) + turned.center, turned.radius});
  }
  return inflate(Policy::of_balls(std::span<const Ball3<S>>(lists.balls)), node.reference.radius);
}

}  // namespace refitlab
