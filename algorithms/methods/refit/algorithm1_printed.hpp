// SPDX-License-Identifier: MIT
// This is Algorithm 1 of the paper (4.5), as printed. It is unsound; algorithms/runtime/refit/algorithm1_repaired.hpp is sound.
//
// It keeps the angle of line 13 and the ball of line 15 for any angle (Lemma 5 as printed), the division by norms that may be
// zero, and quaternions whose signs come from the matrices (line 3). It has no case for r_E >= 1. Three slips are read for their
// sense: i runs over the joints on line 3, q_i on line 8 is that of joint j_i, and weight vertices and rotation center belong to
// each joint-set.
#pragma once

#include "algorithms/runtime/refit/ball_policy.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/tree/refit_node.hpp"
#include "lemmas/lemma3_sphere_surface_intersection.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/s43_rotated_cap.hpp"

namespace refitlab {

// Signs says where the quaternions of line 3 get their signs.
enum class Signs {
  of_matrices,  // as printed: MATRIX2QUAT knows the rotation only
  of_skinning   // the ones that the skinning blends
};

// Returns the quaternion that the usual conversion from a matrix returns for the rotation of q [Eberly 2001]. It is positive in
// the real part if the matrix has a positive trace, else in the largest imaginary part. Nothing else of a unit q changes.
template <class S>
Quaternion<S> matrix_to_quaternion(const Quaternion<S>& q) {
  int positive = 0;
  if (!(S(1) < S(4) * sq(q[0]))) {  // the trace is 4 w^2 - 1
    positive = 1;
    for (int i = 2; i <= 3; ++i)
      if (sq(q[positive]) < sq(q[i])) positive = i;
  }
  return q[positive] < S(0) ? Quaternion<S>(-q) : q;
}

// In float and double the result may be not a number or have a negative radius, as the printed algorithm has it.
template <class Policy, class S>
Ball3<S> refit_algorithm1_printed(const RefitNode<S>& node, Signs signs, RefitLists<S>& lists) {
  lists.balls.clear();                        // line 1
  for (const NodePiece& set : node.pieces) {  // line 4
    const PaletteEntry<S> palette = node.palette[set.joint_set];
    lists.quaternions.clear();                           // line 5
    for (int k = 0; k < set.weight_vertex_count; ++k) {  // line 6
      const auto weight_vertex = node.weight_vertex(set, k);
      Quaternion<S> blend = Quaternion<S>::Constant(S(0));
      for (std::size_t i = 0; i < weight_vertex.size(); ++i) {  // lines 3 and 8
        const Quaternion<S>& q = palette.transforms[i].rotation;
        blend = blend + (signs == Signs::of_matrices ? matrix_to_quaternion(q) : q) * weight_vertex[i];
      }
      lists.quaternions.push_back(direction_by_root(blend));  // lines 9 and 10
    }
    const std::span<const Quaternion<S>> unit(lists.quaternions);
    const Quaternion<S> center = Policy::template center_of_points<S, 4>(unit);  // line 11
    const S squared_radius = farthest_squared_distance(center, unit);
    const Quaternion<S> apex = direction_by_root(center);  // line 12
    // Line 13 has alpha = 2 arccos d, with the distance d of Lemma 3's half-space. So these are its cosine and sine
    // (s43_rotated_cap).
    const S d = scaled_distance(center, squared_radius) / (S(2) * norm(center));
    const S cos_alpha = rotated_cap_cosine_printed(d);
    const S sin_alpha = rotated_cap_sine_printed(d);
    const Vec<S, 3> u = node.reference.center - palette.rotation_center;
    // Line 15 makes the ball around the cap, by Lemma 5 as printed.
    const Ball3<S> turned = cap_ball_printed<S, 3>(rotate(apex, u), norm(u), cos_alpha, sin_alpha);
    for (int k = 0; k < set.weight_vertex_count; ++k)  // lines 7 and 14: moved by the linear part
      lists.balls.push_back({blend_center(palette, node.weight_vertex(set, k)) + turned.center, turned.radius});
  }
  return inflate(Policy::of_balls(std::span<const Ball3<S>>(lists.balls)), node.reference.radius);  // line 16
}

}  // namespace refitlab
