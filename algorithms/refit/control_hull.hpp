// Control balls: blend skinning as a rational Bezier simplex in the weights, whose control points hold all of it.
//
// Let q'_k and r'_k be a piece's corner quaternions and corner images of the rotation center, and x = p - r_c. With
//   W_kl = (q'_k, q'_l)   and   P_kl = Im(q'_k x q'_l* + q'_l x q'_k*) / 2
// the image of x under the blend sum u_k q'_k is sum u_k u_l P_kl / sum u_k u_l W_kl; times the same denominator the
// linear part makes Equation (1) a rational Bezier simplex of degree 3 with, for j <= k <= l,
//   W_jkl = (W_jk + W_kl + W_jl) / 3
//   N_jkl = (P_jk + P_kl + P_jl) / 3 + (r'_j W_kl + r'_k W_jl + r'_l W_jk) / 3.
// If all W_kl are positive, the skinned p is a convex combination of the control points N_jkl / W_jkl, and the whole
// reference ball stays within its radius of their hull. Rotations far apart make the control points stray, so a simplex
// with corners 120 degrees apart or more, or with a corner that is 0, is halved (de Casteljau) at its widest edge, a
// few times; what is still so wide then falls back on the cap bound of Algorithm 1 repaired, which is no larger there.
// So the W_kl divided by are never small against the corners. The lemmas: b1_rational_bezier_simplex to
// b5_rotation_axis.
#pragma once

#include <vector>

#include "algorithms/refit/algorithm1_repaired.hpp"

namespace refitlab {

// One corner of a weight simplex, with what is linear in the weights there.
template <class S>
struct ControlCorner {
  Quaternion<S> rotation;  // q'_k, not of unit length
  Vec<S, 3> center_image;  // r'_k
};

// Reused between calls, so that a refit does not allocate.
template <class S>
struct ControlLists {
  RefitLists<S> cap;                      // balls (the result) and the quaternions of the fallback
  std::vector<ControlCorner<S>> corners;  // of the simplices in work, one after the other
  std::vector<S> dots;                    // W_kl, m x m
  std::vector<Vec<S, 3>> products;        // P_kl, m x m
};

inline constexpr int most_halvings = 4;  // in a row: 16 sub-simplices at most

template <class S>
class ControlHull {
 public:
  // Balls of this radius are appended to lists.cap.balls. x is p - r_c.
  ControlHull(const Vec<S, 3>& x, const S& radius, ControlLists<S>& lists) : x_(x), radius_(radius), lists_(lists) {}

  // The simplex whose m corners are the last of lists.corners, which are gone afterwards.
  void cover(std::size_t m, int halvings_left) {
    const std::size_t first = lists_.corners.size() - m;
    multiply_all(first, m);
    const auto [k, l] = widest_edge(m);
    if (is_near(m, k, l)) {
      emit(first, m);
    } else if (halvings_left > 0) {
      halve(first, m, k, l, halvings_left);
    } else {
      cap(first, m);
    }
    lists_.corners.resize(first);
  }

 private:
  S& dots(std::size_t m, std::size_t k, std::size_t l) { return lists_.dots[k * m + l]; }
  Vec<S, 3>& products(std::size_t m, std::size_t k, std::size_t l) { return lists_.products[k * m + l]; }

  // W and P of every pair. With q = (w, v): P_kl = (w_k w_l - v_k.v_l) x + (v_k.x) v_l + (v_l.x) v_k + (w_k v_l + w_l
  // v_k) x x.
  void multiply_all(std::size_t first, std::size_t m) {
    lists_.dots.resize(m * m);
    lists_.products.resize(m * m);
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t l = 0; l <= k; ++l) {
        const Quaternion<S>&a = lists_.corners[first + k].rotation, &b = lists_.corners[first + l].rotation;
        const Vec<S, 3> va = imaginary(a), vb = imaginary(b);
        const S real = a[0] * b[0], imag = dot(va, vb);
        const Vec<S, 3> turn = cross<S>(vb * a[0] + va * b[0], x_);
        dots(m, k, l) = dots(m, l, k) = real + imag;
        products(m, k, l) = products(m, l, k) = x_ * (real - imag) + vb * dot(va, x_) + va * dot(vb, x_) + turn;
      }
  }

  // Less than 120 degrees of rotation apart, 60 degrees between the quaternions, which are certainly not 0.
  bool is_near(std::size_t m, std::size_t k, std::size_t l) {
    const S& w = dots(m, k, l);
    return certainly_less(S(0), w) && certainly_less(S(dots(m, k, k) * dots(m, l, l)), S(S(4) * sq(w)));
  }

  // The pair of corners with the smallest normalised dot product, compared without roots or quotients. A corner that
  // may be 0 makes any pair of it the widest.
  std::pair<std::size_t, std::size_t> widest_edge(std::size_t m) {
    std::pair<std::size_t, std::size_t> widest{m > 1 ? 1 : 0, 0};
    const auto signed_square = [&](std::size_t k, std::size_t l) {
      const S& w = dots(m, k, l);
      return prefer_less(w, S(0)) ? S(-sq(w)) : sq(w);
    };
    const auto lengths = [&](std::size_t k, std::size_t l) { return S(dots(m, k, k) * dots(m, l, l)); };
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t l = 0; l < k; ++l) {
        if (!certainly_less(S(0), lengths(k, l))) return {k, l};
        if (prefer_less(S(signed_square(k, l) * lengths(widest.first, widest.second)),
                        S(signed_square(widest.first, widest.second) * lengths(k, l))))
          widest = {k, l};
      }
    return widest;
  }

  void emit(std::size_t first, std::size_t m) {
    const ControlCorner<S>* corner = lists_.corners.data() + first;
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t k = j; k < m; ++k)
        for (std::size_t l = k; l < m; ++l) {
          const S &w_jk = dots(m, j, k), &w_kl = dots(m, k, l), &w_jl = dots(m, j, l);
          const Vec<S, 3> turned = products(m, j, k) + products(m, k, l) + products(m, j, l);
          const Vec<S, 3> moved =
              corner[j].center_image * w_kl + corner[k].center_image * w_jl + corner[l].center_image * w_jk;
          const S scale = S(1) / (w_jk + w_kl + w_jl);
          lists_.cap.balls.push_back({(turned + moved) * scale, radius_});
        }
  }

  // The two simplices that share the middle of the edge (k, l).
  void halve(std::size_t first, std::size_t m, std::size_t k, std::size_t l, int halvings_left) {
    const ControlCorner<S> a = lists_.corners[first + k], b = lists_.corners[first + l];
    const ControlCorner<S> middle{(a.rotation + b.rotation) / S(2), (a.center_image + b.center_image) / S(2)};
    for (const std::size_t replaced : {k, l}) {
      const std::size_t own = lists_.corners.size();
      for (std::size_t i = 0; i < m; ++i) lists_.corners.push_back(ControlCorner<S>(lists_.corners[first + i]));
      lists_.corners[own + replaced] = middle;
      cover(m, halvings_left - 1);
    }
  }

  // The fallback: the rotations' cap, and the linear part's corners.
  void cap(std::size_t first, std::size_t m) {
    auto& unit = lists_.cap.quaternions;
    unit.clear();
    RotationBound<S> bound = all_rotations<S>();
    for (std::size_t k = 0; k < m; ++k) {
      const Quaternion<S>& q = lists_.corners[first + k].rotation;
      const S squared_length = squared_norm(q);
      if (certainly_less(S(0), squared_length)) unit.push_back(q / root(squared_length));
    }
    if (unit.size() == m) {
      const std::span<const Quaternion<S>> points(unit);
      bound = bound_rotations(points, mean_center(points));
    }
    const Vec<S, 3> offset = rotate(bound.apex, x_) * bound.center_ratio;
    const S radius = radius_ + bound.radius_ratio * norm(x_);
    for (std::size_t k = 0; k < m; ++k)
      lists_.cap.balls.push_back({lists_.corners[first + k].center_image + offset, radius});
  }

  const Vec<S, 3> x_;
  const S radius_;
  ControlLists<S>& lists_;
};

// A single corner with a blend that is certainly not zero: the whole piece moves rigidly.
template <class S>
bool is_one_rotation(const JointSetPose<S>& pose, const RefitNode<S>& node, const NodeJointSet& set) {
  return set.corner_count == 1 && certainly_less(S(0), squared_norm(blend_quaternion(pose, node.corner(set, 0))));
}

// Balls whose convex hull contains the node's vertices under spherical blending, in lists.cap.balls: what any convex
// bounding volume can be put around.
template <class S>
std::span<const Ball3<S>> control_balls(const RefitNode<S>& node, ControlLists<S>& lists) {
  lists.cap.balls.clear();
  for (std::size_t i = 0; i < node.joint_sets.size(); ++i) {
    const NodeJointSet& set = node.joint_sets[i];
    const JointSetPose<S>& pose = node.pose[set.joint_set];
    const Ball3<S>& reference = node.piece_reference(i);
    if (is_one_rotation(pose, node, set)) {
      lists.cap.balls.push_back({blend_spherical(pose, node.corner(set, 0), reference.center), reference.radius});
      continue;
    }
    lists.corners.clear();
    for (int k = 0; k < set.corner_count; ++k)
      lists.corners.push_back({blend_quaternion(pose, node.corner(set, k)), blend_center(pose, node.corner(set, k))});
    ControlHull<S>(reference.center - pose.rotation_center, reference.radius, lists)
        .cover(lists.corners.size(), set.corner_count == 1 ? 0 : most_halvings);
  }
  return lists.cap.balls;
}

// One ball around the control balls.
template <class Policy, class S>
Ball3<S> refit_control_hull(const RefitNode<S>& node, ControlLists<S>& lists) {
  return Policy::of_balls(control_balls(node, lists));
}

}  // namespace refitlab
