// SPDX-License-Identifier: MIT
// Computes the smallest enclosing ball of points of R^d, with its support, by walking [Fischer, Gaertner and Kutz 2003, "Fast
// smallest-enclosing-ball computation in high dimensions"].
//
// The center starts anywhere and the support is the point farthest from it. The center walks towards the affine hull of
// the support, so that all of the support stays equally far; a point that would fall outside stops the walk and joins the
// support. Once the center is in the hull, a support point with a negative coefficient leaves, and where there is none
// the ball is smallest. Only + - * / are needed: the same template runs in double and decides in exact rationals.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "algorithms/runtime/balls/mean_ball.hpp"
#include "algorithms/runtime/balls/scaling.hpp"

namespace refitlab {

// The certificate of a smallest ball is that its center is a convex combination of support points that all lie on its boundary.
template <class S, int D>
struct SmallestBall {
  Vec<S, D> center;
  S squared_radius;                   // of the farthest point, so that the ball encloses all of them
  std::array<int, D + 1> support;     // indices of the points, the first support_size of them
  std::array<S, D + 1> coefficients;  // of the combination: non-negative, sum 1
  int support_size = 0;
  int steps = 0;           // of the walk: projections on a hull
  bool converged = false;  // false only where rounding kept the walk from ending (never in exact numbers)
};

// Returns the result for points that are not finite. It has no center, no radius and no support.
template <class S, int D>
SmallestBall<S, D> undefined_smallest_ball() {
  constexpr S undefined = std::numeric_limits<S>::quiet_NaN();
  SmallestBall<S, D> ball;
  ball.center = Vec<S, D>::Constant(undefined);
  ball.squared_radius = undefined;
  return ball;
}

// Returns the rounding error of one sum of products, relative to the radius.
template <class S>
S rounding_noise() {
  if constexpr (std::is_floating_point_v<S>) return 32 * std::numeric_limits<S>::epsilon();
  else return S(0);
}

// All positions are relative to the first point, so that a small cloud far from the origin loses no digits.
template <class S, int D>
class SmallestBallWalk {
 public:
  explicit SmallestBallWalk(std::span<const Vec<S, D>> points) : points_(points), center_(position(0)) {
    ball_.support[0] = farthest_from_first();
    ball_.support_size = 1;
  }

  SmallestBall<S, D> run() {
    // Dropping the most negative coefficient is fast and in rare degenerate cases cycles; the smallest index never does,
    // but for rounding, which in some of a million degenerate cases keeps a cycle alive until more of it counts as zero.
    const int patience = 20 * D + static_cast<int>(points_.size()), limit = 20 * patience;
    while (!ball_.converged && ball_.steps < limit) {
      if (++ball_.steps % patience == 0) noise_ = noise_ * S(2);
      squared_radius_ = squared_distance(position(ball_.support[0]), center_);
      project_on_hull();
      if (ball_.support_size <= D && sq(tolerance()) * squared_radius_ < squared_norm(walk_)) walk_to_hull();
      else if (const int unneeded = negative_coefficient(ball_.steps < patience); unneeded >= 0) drop(unneeded);
      else ball_.converged = true;
    }
    ball_.center = points_[0] + center_;
    ball_.squared_radius = farthest_squared_distance(ball_.center, points_);
    return ball_;
  }

 private:
  // Returns the size that counts as zero after a few steps, relative to the radius. Rounding grows in a walk, and must not steer
  // it.
  S tolerance() const { return S(128) * noise_; }

  Vec<S, D> position(int i) const { return points_[i] - points_[0]; }

  int farthest_from_first() const {
    int index = 0;
    S far(0);
    for (int i = 1; i < static_cast<int>(points_.size()); ++i) {
      const S d = squared_distance(points_[i], points_[0]);
      if (far < d) far = d, index = i;
    }
    return index;
  }

  bool in_support(int i) const {
    for (int k = 0; k < ball_.support_size; ++k)
      if (ball_.support[k] == i) return true;
    return false;
  }

  // Finds the walk from the center to its projection on the support's hull, and the coefficients of that projection, by
  // making the edges from the first support point orthogonal (Gram-Schmidt without roots, on what is left of each vector:
  // products of whole edges would lose the digits of a thin support).
  void project_on_hull() {
    const int n = ball_.support_size - 1;
    const Vec<S, D> base = position(ball_.support[0]);
    std::array<Vec<S, D>, D> axis;
    std::array<S, D> squared_length, on_axis;
    std::array<std::array<S, D>, D> share;  // edge i = axis i + sum over j < i of share ij times axis j
    walk_ = base - center_;
    for (int i = 0; i < n; ++i) {
      axis[i] = position(ball_.support[i + 1]) - base;
      for (int j = 0; j < i; ++j) {
        share[i][j] = dot(axis[i], axis[j]) / squared_length[j];
        axis[i] = axis[i] - axis[j] * share[i][j];
      }
      squared_length[i] = squared_norm(axis[i]);
      on_axis[i] = -dot(walk_, axis[i]) / squared_length[i];
      walk_ = walk_ + axis[i] * on_axis[i];
    }
    ball_.coefficients[0] = S(1);
    for (int i = n; i-- > 0;) {
      S& x = ball_.coefficients[i + 1] = on_axis[i];
      for (int k = i + 1; k < n; ++k) x = x - share[k][i] * ball_.coefficients[k + 1];
      ball_.coefficients[0] = ball_.coefficients[0] - x;
    }
  }

  // Moves the center to its projection, or only as far as no other point falls outside. That point then joins the support.
  void walk_to_hull() {
    const Vec<S, D>& on_boundary = points_[ball_.support[0]];
    const Vec<S, D> center = center_, walk = walk_;
    // A point that joins must be off the support's hull by more than rounding, which is above all that of the walk's direction.
    const S too_flat = squared_radius_ * max_of(S(sq(tolerance()) * squared_norm(walk)), S(sq(noise_) * squared_radius_));
    const S touching = tolerance() * squared_radius_;
    S fraction(1);
    int stop = -1;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      const S approach = dot<S, D>(points_[i] - on_boundary, walk);  // negative: the boundary moves over this point
      if (!(approach < S(0)) || !(too_flat < sq(approach)) || in_support(i)) continue;
      const S slack = squared_radius_ - squared_distance<S, D>(position(i), center);
      const S hit = touching < slack ? S(slack / (S(-2) * approach)) : S(0);
      if (hit < fraction) fraction = hit, stop = i;
    }
    center_ = center_ + walk_ * fraction;
    if (stop >= 0) ball_.support[ball_.support_size++] = stop;
  }

  // Returns the position in the support of the most negative coefficient, or of the negative one of smallest index, or -1 if
  // there is none.
  int negative_coefficient(bool most_negative) const {
    const auto& x = ball_.coefficients;
    int found = -1;
    for (int k = 0; k < ball_.support_size; ++k)
      if (x[k] < S(0) && (found < 0 || (most_negative ? x[k] < x[found] : ball_.support[k] < ball_.support[found]))) found = k;
    return found;
  }

  void drop(int position) {
    --ball_.support_size;
    for (int k = position; k < ball_.support_size; ++k) ball_.support[k] = ball_.support[k + 1];
  }

  std::span<const Vec<S, D>> points_;
  S noise_ = rounding_noise<S>();
  Vec<S, D> center_, walk_;
  S squared_radius_;
  SmallestBall<S, D> ball_;
};

// points is not empty. In double the result always encloses all points up to the rounding of one squared distance; it is smallest
// up to rounding if converged, as long as squares of distances do not overflow.
template <class S, int D>
SmallestBall<S, D> smallest_ball(std::span<const Vec<S, D>> points) {
  if constexpr (std::is_floating_point_v<S>) {
    S greatest(0);
    for (const Vec<S, D>& p : points) greatest = max_of(greatest, S((p - points[0]).cwiseAbs().maxCoeff()));
    if (const int scaling = scaling_of(greatest); scaling != 0) {
      std::vector<Vec<S, D>> of_size_one;
      for (const Vec<S, D>& p : points) of_size_one.push_back(times_power_of_two(Vec<S, D>(p - points[0]), -scaling));
      SmallestBall<S, D> ball = SmallestBallWalk<S, D>(of_size_one).run();
      ball.center = points[0] + times_power_of_two(ball.center, scaling);
      ball.squared_radius = farthest_squared_distance(ball.center, points);
      return ball;
    }
  }
  return SmallestBallWalk<S, D>(points).run();
}

template <class S, int D>
Ball<S, D> as_ball(const SmallestBall<S, D>& smallest) {
  return {smallest.center, root(smallest.squared_radius)};
}

}  // namespace refitlab
