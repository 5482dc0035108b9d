// SPDX-License-Identifier: MIT
// Refitting for dual quaternion skinning makes control balls, of degree 2, and one ball around them.
//
// Let q'_k + eps d'_k be the dual quaternion at weight vertex k of a piece, and p the center of its reference ball. Let
// W_kl and P_kl be as in control_hull.hpp, but P_kl of p itself, and
//   N_kl = P_kl + T_kl,   T_kl = Im(d'_k q'_l* + d'_l q'_k*),
// The image of p under the blend with weights u is sum u_k u_l N_kl / sum u_k u_l W_kl. If all W_kl are positive, this is a
// convex combination of the control points N_kl / W_kl (b1_rational_bezier_simplex, b2_control_hull_encloses). The blend is
// rigid, so the reference ball stays within its radius of their hull. Simplices are halved as for spherical blending, but
// already from a right angle on: degree 2 has fewer control points, which stray sooner (b4_cap_fallback). A simplex that is
// still so wide after that falls back on the ball of b6_dual_quaternion_ball. This ball is larger the nearer a blend is to
// 0. If a blend may be 0, no ball encloses the images under its neighbours, because these carry a vertex arbitrarily far.
#pragma once

#include <limits>

#include "algorithms/runtime/refit/control_hull.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b3_subdivision.hpp"
#include "lemmas/b6_dual_quaternion_ball.hpp"

namespace refitlab {

// Returns all of space as a ball: one of infinite radius about a point.
template <class S>
Ball3<S> all_of_space(const Vec<S, 3>& center) {
  return {center, S(std::numeric_limits<double>::infinity())};
}

// The fallback takes no axis a whose cosine to some q'_k is less than this, and no q'_k that is shorter than the least length:
// smaller ones may come from rounding.
inline constexpr double least_fallback_cosine = 1e-4, least_fallback_length = 1e-2;

// Returns what a fallback in double may lose by rounding, relative to the sum of its radius, t, ||p|| and ||f||, for this many
// joints. The q'_k and d'_k are off by (n + 4) u of 1 and of half of t. So the E_k are off by (n + 14) u of t + ||p|| + ||f||,
// and (q'_k, a) / ||a|| by (n + 8) u. Both errors are divided by (q'_k, a) / ||a||, which is at least the least cosine times the
// least length. proptests/algorithms/control_budgets.cpp derives these counts.
constexpr double fallback_slack(double joints) {
  return (joints + 16) * (std::numeric_limits<double>::epsilon() / 2) / (least_fallback_cosine * least_fallback_length);
}

// DualQuaternionPiece is the dual quaternion blend of a piece.
template <class S>
class DualQuaternionPiece {
 public:
  using Number = S;
  using WeightVertex = BlendedDuals<S>;
  static constexpr double near = near_of_degree_two;

  // point is p, and radius is that of the reference ball. For rounding there are the number of joints, and translation, which is
  // at least the length of every joint's translation.
  DualQuaternionPiece(const Vec<S, 3>& point, const S& radius, const S& joints = S(1), const S& translation = S(0))
      : point_(point),
        radius_(radius),
        joints_(joints),
        translation_(translation) {}

  MixedPair<S> mix(const WeightVertex& a, const WeightVertex& b) const { return mix_motions(a, b, point_); }
  static WeightVertex middle(const WeightVertex& a, const WeightVertex& b) {
    return {middle_of(a.rotation, b.rotation), middle_of(a.dual, b.dual)};
  }

  void emit(std::span<const WeightVertex> weight_vertex, ControlLists<S>& lists) const {
    const std::size_t m = weight_vertex.size();
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t l = k; l < m; ++l) lists.cap.balls.push_back({lists.products[k * m + l] / lists.dots[k * m + l], radius_});
  }

  // Makes the ball of b6_dual_quaternion_ball about the mean of the images at the weight vertices, for an axis that all of these are
  // ahead of. If it finds no such axis, there is no bound.
  void fall_back(std::span<const WeightVertex> weight_vertex, ControlLists<S>& lists) {
    const Quaternion<S> axis = axis_of(weight_vertex);
    if (!is_ahead(weight_vertex, axis)) {
      is_bounded_ = false;
      return;
    }
    const std::size_t m = weight_vertex.size();
    Vec<S, 3> middle = Vec<S, 3>::Constant(S(0));
    for (std::size_t k = 0; k < m; ++k) middle = middle + lists.products[k * m + k] / lists.dots[k * m + k];
    middle = middle / S(static_cast<double>(m));
    const S reach = root(dual_quaternion_ball(weight_vertex, point_, axis, middle).squared_radius);
    lists.cap.balls.push_back({middle, radius_ + reach + rounding_of(middle, reach)});
  }

  bool is_bounded() const { return is_bounded_; }

  // The axis is the mean of the q'_k. While some q'_k is behind it, it takes a few steps towards the point of their hull
  // that is nearest to 0 [Gilbert 1966]. All q'_k are ahead of that point unless it is 0.
  static Quaternion<S> axis_of(std::span<const WeightVertex> weight_vertex) {
    Quaternion<S> axis = Quaternion<S>::Constant(S(0));
    for (const WeightVertex& c : weight_vertex) axis = axis + c.rotation;
    axis = axis / S(static_cast<double>(weight_vertex.size()));
    for (int step = 0; step < axis_steps && !is_ahead(weight_vertex, axis); ++step) {
      const WeightVertex* last = &weight_vertex[0];
      for (const WeightVertex& c : weight_vertex)
        if (prefer_less(S(dot(c.rotation, axis)), S(dot(last->rotation, axis)))) last = &c;
      const Quaternion<S> edge = last->rotation - axis;
      const S squared_length = squared_norm(edge);
      if (!certainly_less(S(0), squared_length)) break;
      axis = axis + edge * min_of(S(-dot(edge, axis) / squared_length), S(1));
    }
    return axis;
  }

 private:
  static constexpr int axis_steps = 6;
  static constexpr double least_squared_cosine =
      std::is_floating_point_v<S> ? least_fallback_cosine * least_fallback_cosine : 1e-20;
  static constexpr double least_squared_weight_vertex =
      std::is_floating_point_v<S> ? least_fallback_length * least_fallback_length : 0;

  S rounding_of(const Vec<S, 3>& middle, const S& reach) const {
    if constexpr (!std::is_floating_point_v<S>) return S(0);
    else {
      static_assert(std::is_same_v<S, double>);
      return S(fallback_slack(joints_)) * (reach + translation_ + norm(point_) + norm(middle));
    }
  }

  static bool is_ahead(std::span<const WeightVertex> weight_vertex, const Quaternion<S>& axis) {
    for (const WeightVertex& c : weight_vertex) {
      const S along = dot(c.rotation, axis), lengths = squared_norm(c.rotation) * squared_norm(axis);
      const S least = S(least_squared_cosine) * lengths;
      if (!certainly_less(S(0), along) || !certainly_less(least, sq(along))) return false;
      if (!certainly_less(S(least_squared_weight_vertex), squared_norm(c.rotation))) return false;
    }
    return true;
  }

  const Vec<S, 3> point_;
  const S radius_, joints_, translation_;
  bool is_bounded_ = true;
};

// Makes balls in lists.cap.balls, whose convex hull contains the node's vertices under dual quaternion blending. If some
// admissible blend may be 0, the only ball is all of space.
template <class S>
std::span<const Ball3<S>> control_balls_dual_quaternion(const RefitNode<S>& node, ControlLists<S>& lists) {
  auto& balls = lists.cap.balls;
  balls.clear();
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    const NodePiece& set = node.pieces[i];
    const PaletteEntry<S> palette = node.palette[set.joint_set];
    const Ball3<S>& reference = node.piece_reference(i);
    if (set.weight_vertex_count == 1) {  // one rigid transform, unless its blend may be zero
      const BlendedDuals<S> only = blend_duals(palette, node.weight_vertex(set, 0));
      if (const S squared_length = squared_norm(only.rotation); is_certainly_nonzero(squared_length)) {
        balls.push_back({move_rigidly(only, squared_length, reference.center), reference.radius});
        continue;
      }
    }
    lists.dual_weight_vertices.clear();
    for (int k = 0; k < set.weight_vertex_count; ++k)
      lists.dual_weight_vertices.push_back(blend_duals(palette, node.weight_vertex(set, k)));
    S joints(1), translation(0);
    if constexpr (std::is_floating_point_v<S>) {
      const PaletteScales<S>& scales = node.palette.scales(set.joint_set);
      joints = scales.joints, translation = scales.translation;
    }
    DualQuaternionPiece<S> piece(reference.center, reference.radius, joints, translation);
    ControlHull(piece, lists.dual_weight_vertices, lists)
        .cover(lists.dual_weight_vertices.size(), set.weight_vertex_count == 1 ? 0 : most_halvings);
    if (!piece.is_bounded()) {
      balls.assign(1, all_of_space(reference.center));
      break;
    }
  }
  return balls;
}

// Returns one ball around the control balls. If there is only one, it is that ball.
template <class Policy, class S>
Ball3<S> refit_dual_quaternion(const RefitNode<S>& node, ControlLists<S>& lists) {
  const std::span<const Ball3<S>> balls = control_balls_dual_quaternion(node, lists);
  return balls.size() == 1 ? balls[0] : Policy::of_balls(balls);
}

}  // namespace refitlab
