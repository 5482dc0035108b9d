// SPDX-License-Identifier: MIT
// Blend skinning is a rational Bezier simplex in the weights, and the hull of its control points holds every blend. Here the
// simplices of a piece are halved until their control points are near, and become balls.
//
// Let q'_k and r'_k be the quaternion and the image of the rotation center at weight vertex k of a piece, and let x = p -
// r_c. The control points N_jkl / W_jkl are those of b1_rational_bezier_simplex, of degree 3.
// If all W_kl are positive, the skinned p is a convex combination of the control points N_jkl / W_jkl, and the whole
// reference ball stays within its radius of their hull. If rotations are far apart, the control points stray far from the
// surface. So a simplex is halved (de Casteljau) at its widest edge, a few times, if it has rotations 120 degrees apart or
// more, or a q'_k that is 0. A simplex that is still so wide then falls back on the cap bound of Algorithm 1 repaired,
// which is no larger there. So no divisor W_kl is small relative to the quaternions. That control points hold the blend is
// b2_control_hull_encloses, that halving is sound is b3_subdivision, and the fallback is rotation_bound; b4_cap_fallback is what
// certificates say in its place.
//
// All blends of quaternions share the halving: ControlHull is a template over the blend of a piece.
#pragma once

#include "algorithms/runtime/refit/algorithm1_repaired.hpp"
#include "algorithms/runtime/refit/control_lists.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b3_subdivision.hpp"
#include "lemmas/rotation_bound.hpp"

namespace refitlab {

inline constexpr int most_halvings = 4;  // in a row: 16 sub-simplices at most

// Blend is the blend of one piece. It has the types Number and WeightVertex; a WeightVertex is the data at a weight vertex,
// and its rotation is a quaternion. mix(a, b) makes N and W of two weight vertices, and
// middle(a, b) the weight vertex half-way. near is a constant: weight vertices are near if (q'_k, q'_l) > 0 and its
// square times near is above ||q'_k||^2 ||q'_l||^2. For a given simplex, emit (for near weight vertices) and fall_back
// (for others) append balls to lists.cap.balls.
template <class Blend>
class ControlHull {
  using S = typename Blend::Number;
  using WeightVertex = typename Blend::WeightVertex;

 public:
  // weight_vertices is a list of lists.
  ControlHull(Blend& blend, std::vector<WeightVertex>& weight_vertices, ControlLists<S>& lists)
      : blend_(blend),
        weight_vertices_(weight_vertices),
        lists_(lists) {}

  // Bounds the simplex whose m weight vertices are the last ones in the list, and removes them from it.
  void cover(std::size_t m, int halvings_left) {
    const std::size_t first = weight_vertices_.size() - m;
    mix_all(first, m);
    const auto [k, l] = widest_edge<S>(m, [&](std::size_t a, std::size_t b) -> const S& { return dots(m, a, b); });
    if (is_near(m, k, l)) {
      blend_.emit(simplex(first, m), lists_);
    } else if (halvings_left > 0) {
      halve(first, m, k, l, halvings_left);
    } else {
      blend_.fall_back(simplex(first, m), lists_);
    }
    weight_vertices_.resize(first);
  }

 private:
  std::span<const WeightVertex> simplex(std::size_t first, std::size_t m) const { return {weight_vertices_.data() + first, m}; }
  S& dots(std::size_t m, std::size_t k, std::size_t l) { return lists_.dots[k * m + l]; }

  // Computes W and N of every pair.
  void mix_all(std::size_t first, std::size_t m) {
    lists_.dots.resize(m * m);
    lists_.products.resize(m * m);
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t l = 0; l <= k; ++l) {
        const MixedPair<S> mixed = blend_.mix(weight_vertices_[first + k], weight_vertices_[first + l]);
        dots(m, k, l) = dots(m, l, k) = mixed.weight;
        lists_.products[k * m + l] = lists_.products[l * m + k] = mixed.numerator;
      }
  }

  // Says whether the weight vertices are as near as the blend requires, and certainly not 0.
  bool is_near(std::size_t m, std::size_t k, std::size_t l) {
    const S &of_k = dots(m, k, k), &of_l = dots(m, l, l);
    return is_certainly_nonzero(of_k) && is_certainly_nonzero(of_l) && are_near(dots(m, k, l), of_k, of_l, Blend::near);
  }

  // Makes the two simplices that share the middle of the edge (k, l).
  void halve(std::size_t first, std::size_t m, std::size_t k, std::size_t l, int halvings_left) {
    const WeightVertex middle = blend_.middle(weight_vertices_[first + k], weight_vertices_[first + l]);
    for (const std::size_t replaced : {k, l}) {
      const std::size_t own = weight_vertices_.size();
      for (std::size_t i = 0; i < m; ++i) weight_vertices_.push_back(WeightVertex(weight_vertices_[first + i]));
      weight_vertices_[own + replaced] = middle;
      cover(m, halvings_left - 1);
    }
  }

  Blend& blend_;
  std::vector<WeightVertex>& weight_vertices_;
  ControlLists<S>& lists_;
};

// SphericalPiece is the spherical blend of a piece by Equation (1). It has degree 3.
template <class S>
class SphericalPiece {
 public:
  using Number = S;
  using WeightVertex = BlendedJoints<S>;
  static constexpr double near = near_of_degree_three;

  // x is p - r_c, and radius is that of the reference ball.
  SphericalPiece(const Vec<S, 3>& x, const S& radius) : x_(x), radius_(radius) {}

  MixedPair<S> mix(const WeightVertex& a, const WeightVertex& b) const { return mix_rotations(a.rotation, b.rotation, x_); }
  static WeightVertex middle(const WeightVertex& a, const WeightVertex& b) {
    return {middle_of(a.rotation, b.rotation), middle_of(a.center_image, b.center_image)};
  }

  void emit(std::span<const WeightVertex> weight_vertex, ControlLists<S>& lists) const {
    const std::size_t m = weight_vertex.size();
    const auto mixed = [&](std::size_t k, std::size_t l) {
      return MixedPair<S>{lists.dots[k * m + l], lists.products[k * m + l]};
    };
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t k = j; k < m; ++k)
        for (std::size_t l = k; l < m; ++l) {
          const ScaledPoint<S> point =
              spherical_control_point(mixed(j, k), mixed(k, l), mixed(j, l), weight_vertex[j].center_image,
                                      weight_vertex[k].center_image, weight_vertex[l].center_image);
          const S scale = S(1) / point.denominator;
          lists.cap.balls.push_back({point.numerator * scale, radius_});
        }
  }

  // Bounds the rotations by a cap, and the linear part by its values at the weight vertices.
  void fall_back(std::span<const WeightVertex> weight_vertex, ControlLists<S>& lists) const {
    const auto blend = [&](std::size_t k) { return weight_vertex[k].rotation; };
    const auto bound = bound_weight_vertex_rotations<MeanBalls, S>(weight_vertex.size(), blend, lists.cap.quaternions);
    const Ball3<S> turned = rotated_ball(bound, x_);
    const S radius = radius_ + turned.radius;
    for (const WeightVertex& c : weight_vertex) lists.cap.balls.push_back({c.center_image + turned.center, radius});
  }

 private:
  const Vec<S, 3> x_;
  const S radius_;
};

// Makes balls in lists.cap.balls. Their convex hull contains the node's vertices under spherical blending, so any convex
// bounding volume can be put around them.
template <class S>
std::span<const Ball3<S>> control_balls(const RefitNode<S>& node, ControlLists<S>& lists) {
  lists.cap.balls.clear();
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    const NodePiece& set = node.pieces[i];
    const PaletteEntry<S> palette = node.palette[set.joint_set];
    const Ball3<S>& reference = node.piece_reference(i);
    const Vec<S, 3> x = reference.center - palette.rotation_center;
    lists.weight_vertices.clear();
    if (set.weight_vertex_count == 1) {  // one rotation, unless its blend may be zero: the whole piece moves rigidly
      const BlendedJoints<S> only = blend_joints(palette, node.weight_vertex(set, 0));
      if (const S squared_length = squared_norm(only.rotation); is_certainly_nonzero(squared_length)) {
        lists.cap.balls.push_back({turn_and_place(only, squared_length, x), reference.radius});
        continue;
      }
    }
    for (int k = 0; k < set.weight_vertex_count; ++k)
      lists.weight_vertices.push_back(blend_joints(palette, node.weight_vertex(set, k)));
    SphericalPiece<S> piece(x, reference.radius);
    ControlHull(piece, lists.weight_vertices, lists)
        .cover(lists.weight_vertices.size(), set.weight_vertex_count == 1 ? 0 : most_halvings);
  }
  return lists.cap.balls;
}

// Returns one ball around the control balls.
template <class Policy, class S>
Ball3<S> refit_control_hull(const RefitNode<S>& node, ControlLists<S>& lists) {
  return Policy::of_balls(control_balls(node, lists));
}

}  // namespace refitlab
