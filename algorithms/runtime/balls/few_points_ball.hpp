// SPDX-License-Identifier: MIT
// Computes the smallest enclosing ball of few points of R^3 or R^4 in float or double, by pivoting.
//
// The support starts as a point far from the first one, and the point farthest from that. As long as a point is outside the
// smallest ball of the support, the farthest such point enters it. That ball grows at every pivot and is as large as the smallest
// ball of all once nothing is outside. The certificate is smallest_ball.hpp's. Where rounding keeps the pivots from ending, the
// walk of smallest_ball.hpp takes over.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "algorithms/runtime/balls/farthest.hpp"
#include "algorithms/runtime/balls/growing_support.hpp"
#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/balls/three_points_ball.hpp"

namespace refitlab {

template <class S, int D>
const Vec<S, D>& center_of(const Vec<S, D>& point) {
  return point;
}
template <class S, int D>
const Vec<S, D>& center_of(const Ball<S, D>& ball) {
  return ball.center;
}

// The items are points, or balls of which the centers count. There are at most `most`, which is a power of two, so that
// everything lives on the stack.
template <class S, int D, int most, class Item = Vec<S, D>>
class FewPoints {
  static_assert(std::is_floating_point_v<S> && (D == 3 || D == 4));

 public:
  // items is not empty.
  explicit FewPoints(std::span<const Item> items) : items_(items), origin_(quad<S>(center_of<S, D>(items[0]))) {}

  // The pivots end as soon as the radius is within 1 + slack of the support's ball, which is no larger than any ball of all
  // points. Returns false if a point is not finite, or if rounding kept the pivots from ending. The support and its center are
  // relative to the first point, so that a small cloud far from the origin loses no digits; only the farthest point is sought
  // from the rounded center.
  bool solve(S slack = S(0)) {
    const S enough = max_of(tolerance, S(1) - S(1) / sq(S(1) + slack));
    const int a = fill_table();
    if (!is_defined_) return false;
    const int b = farthest_from(origin_ + position(a)).index();
    if (a != b) support_.start(a, position(a), b, position(b), S(0.5));
    else support_.start(a, position(a));
    for (; pivots_ < most_pivots; ++pivots_) {
      const Quad<S> center = support_.center();
      center_ = origin_ + center;
      const Farthest<S, most> farthest = farthest_from(center_);
      squared_radius_ = farthest.value();
      const Quad<S> p = position(farthest.index());
      const S far = squared_norm(p - center), low = squared_radius_of_support(center);
      if (far - low <= enough * far) return true;
      if (support_.contains(farthest.index())) return false;
      if (!support_.enter(farthest.index(), p, center, far - low, sq(noise) * far)) return false;
    }
    return false;
  }

  // Returns whether all coordinates and the squares of their differences are finite.
  bool is_defined() const { return is_defined_; }

  SmallestBall<S, D> ball() const {
    SmallestBall<S, D> ball;
    for (int k = 0; k < support_.size(); ++k) {
      ball.support[k] = support_.index(k);
      ball.coefficients[k] = support_.coefficient(k);
    }
    ball.support_size = support_.size();
    ball.steps = pivots_;
    ball.converged = true;
    ball.center = vec<D>(center_);
    ball.squared_radius = squared_radius_;
    return ball;
  }

 private:
  static constexpr int most_pivots = 10 * D + most;
  static constexpr S tolerance = 64 * std::numeric_limits<S>::epsilon();  // of the squared radius
  static constexpr S noise = 512 * std::numeric_limits<S>::epsilon();     // of a distance from the support's hull

  Quad<S> position(int i) const { return quad<S>(center_of<S, D>(items_[i])) - origin_; }

  // Returns a squared radius that no ball around the support is below.
  S squared_radius_of_support(const Quad<S>& center) const {
    S sum(0);
    for (int k = 0; k < support_.size(); ++k) sum += support_.coefficient(k) * squared_norm(support_.position(k) - center);
    return sum;
  }

  // The last point stands twice if the number of points is odd. Returns the index of the point farthest from the first one.
  int fill_table() {
    Farthest<S, most> farthest;
    Row<S, 2> sum{};
    const TwoPoints<S, D> first = same_point_twice<D>(origin_);
    const Item* p = items_.data();
    const int n = static_cast<int>(items_.size());
    for (int i = 0; i < n; i += 2) {
      table_[i / 2] = two_points<S, D>(center_of<S, D>(p[i]), center_of<S, D>(p[i + 1 < n ? i + 1 : i]));
      const Row<S, 2> squares = squared_distances(table_[i / 2], first);
      sum += squares;
      farthest.see(squares);
    }
    is_defined_ = sum[0] + sum[1] < std::numeric_limits<S>::infinity();
    return farthest.index();
  }

  Farthest<S, most> farthest_from(const Quad<S>& center) const {
    Farthest<S, most> farthest;
    const TwoPoints<S, D> c = same_point_twice<D>(center);
    const int rows = (static_cast<int>(items_.size()) + 1) / 2;
    for (int i = 0; i < rows; ++i) farthest.see(squared_distances(table_[i], c));
    return farthest;
  }

  std::span<const Item> items_;
  Quad<S> origin_, center_;
  S squared_radius_;
  bool is_defined_;
  int pivots_ = 0;
  GrowingSupport<S, D> support_;
  std::array<TwoPoints<S, D>, most / 2> table_;
};

// Returns the ball that has the two points as the ends of a diameter.
template <class S, int D>
SmallestBall<S, D> ball_between(const Vec<S, D>& a, const Vec<S, D>& b) {
  SmallestBall<S, D> ball;
  ball.center = a + (b - a) * S(0.5);
  ball.squared_radius = max_of(squared_distance(a, ball.center), squared_distance(b, ball.center));
  ball.support[0] = 0, ball.support[1] = 1;
  ball.coefficients[0] = ball.coefficients[1] = S(0.5);
  ball.support_size = 2;
  ball.converged = true;
  if (!(ball.squared_radius < std::numeric_limits<S>::infinity())) return undefined_smallest_ball<S, D>();
  return ball;
}

// Returns whether all coordinates are finite.
template <class S, int D>
bool are_finite(std::span<const Vec<S, D>> points) {
  return std::all_of(points.begin(), points.end(), [](const Vec<S, D>& p) { return p.allFinite(); });
}

template <int most, class S, int D>
SmallestBall<S, D> pivot_or_walk(std::span<const Vec<S, D>> points) {
  FewPoints<S, D, most> few(points);
  if (few.solve()) return few.ball();
  return few.is_defined() ? smallest_ball(points) : undefined_smallest_ball<S, D>();
}

// points is not empty. This is made for up to 32 points; up to 512 are pivoted too, and more are left to the walk. The squared
// radius is that of the farthest point as computed. If converged, the ball is smallest up to rounding, as long as squares of
// distances neither overflow nor underflow. If a point is not finite, the center and the radius are NaN, and there is
// no support.
template <class S, int D>
SmallestBall<S, D> few_points_ball(std::span<const Vec<S, D>> points) {
  if (points.size() == 2) return ball_between(points[0], points[1]);
  if (points.size() == 3) return three_points_ball(points[0], points[1], points[2]);
  if (points.size() <= 32) return pivot_or_walk<32>(points);
  if (points.size() <= 512) return pivot_or_walk<512>(points);
  if (!are_finite(points)) return undefined_smallest_ball<S, D>();
  return smallest_ball(points);
}

}  // namespace refitlab
