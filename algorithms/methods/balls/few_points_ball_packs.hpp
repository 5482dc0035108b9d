// SPDX-License-Identifier: MIT
// Computes smallest enclosing balls of as many clouds as a SIMD pack has lanes, a cloud a lane. It does the pivots of
// few_points_ball.hpp under masks.
//
// Nothing is gathered: the farthest point's coordinates are selected along with its distance, and an empty place of the support
// is all zeros, which add nothing to any product. Lanes that are done wait for the others.
#pragma once

#include <experimental/simd>
#include <vector>

#include "algorithms/runtime/balls/few_points_ball.hpp"

namespace refitlab {

template <class Pack, int D>
using PackPoint = std::array<Pack, D>;

// This is SmallestBall with a ball in each lane. An empty place of the support has coefficient 0 and index -1, as a number.
template <class Pack, int D>
struct SmallestBallPack {
  PackPoint<Pack, D> center;
  Pack squared_radius;
  std::array<Pack, D + 1> support, coefficients;
  typename Pack::mask_type converged;
};

template <class Pack, int D>
class FewPointsPacks {
  using S = typename Pack::value_type;
  using Mask = typename Pack::mask_type;
  using Point = PackPoint<Pack, D>;

 public:
  // points has the points of all lanes, equally many in each. It is not empty, and has less than 2^24 points in float.
  explicit FewPointsPacks(std::span<const Point> points) : points_(points) {}

  // Lanes that did not converge mean nothing.
  SmallestBallPack<Pack, D> solve() {
    SmallestBallPack<Pack, D> out;
    const Mask is_defined = start();
    Mask active = is_defined;
    for (int pivot = 0; pivot < most_pivots; ++pivot) {
      const Point center = combine(position_, coefficient_);
      for (int i = 0; i < D; ++i) out.center[i] = points_[0][i] + center[i];
      const Farthest farthest = farthest_from(out.center);
      out.squared_radius = farthest.squared_distance;
      Pack low = 0;
      for (int k = 0; k <= D; ++k) low += coefficient_[k] * squared_distance(position_[k], center);
      const Pack far = squared_distance(farthest.position, center);
      out.converged = is_defined && far - low <= tolerance * far;
      active = active && !out.converged;
      for (int k = 0; k <= D; ++k) active = active && index_[k] != farthest.index;
      if (none_of(active)) break;
      enter(farthest, center, far, far - low, active);
    }
    out.support = index_;
    out.coefficients = coefficient_;
    return out;
  }

 private:
  static constexpr int most_pivots = 12;
  static constexpr S epsilon = std::numeric_limits<S>::epsilon();
  static constexpr S tolerance = 64 * epsilon, noise = 512 * epsilon;  // as in FewPoints

  struct Farthest {
    Pack squared_distance = Pack(S(-1)), index = Pack(S(0)), sum = Pack(S(0));  // sum: of all squared distances
    Point position;                                                             // relative to the first point
  };

  static Pack squared_norm(const Point& a) {
    Pack sum = a[0] * a[0];
    for (int i = 1; i < D; ++i) sum += a[i] * a[i];
    return sum;
  }
  static Pack squared_distance(const Point& a, const Point& b) {
    Pack sum = (a[0] - b[0]) * (a[0] - b[0]);
    for (int i = 1; i < D; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
  }
  static Pack dot(const Point& a, const Point& b) {
    Pack sum = a[0] * b[0];
    for (int i = 1; i < D; ++i) sum += a[i] * b[i];
    return sum;
  }
  static Point combine(const std::array<Point, D + 1>& points, const std::array<Pack, D + 1>& weights) {
    Point sum;
    for (int i = 0; i < D; ++i) {
      sum[i] = points[0][i] * weights[0];
      for (int k = 1; k <= D; ++k) sum[i] += points[k][i] * weights[k];
    }
    return sum;
  }

  Farthest farthest_from(const Point& center) const {
    Farthest out;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const Pack square = squared_distance(points_[j], center);
      out.sum += square;
      const Mask farther = square > out.squared_distance;
      where(farther, out.squared_distance) = square;
      where(farther, out.index) = S(static_cast<int>(j));
      for (int i = 0; i < D; ++i) where(farther, out.position[i]) = points_[j][i];
    }
    for (int i = 0; i < D; ++i) out.position[i] -= points_[0][i];
    return out;
  }

  // Returns which lanes are finite.
  Mask start() {
    for (int k = 0; k <= D; ++k) {
      index_[k] = S(-1), coefficient_[k] = S(0);
      for (int i = 0; i < D; ++i) position_[k][i] = gradient_[k][i] = S(0);
    }
    const Farthest a = farthest_from(points_[0]);
    Point first;
    for (int i = 0; i < D; ++i) first[i] = points_[0][i] + a.position[i];
    const Farthest b = farthest_from(first);
    Point edge;
    for (int i = 0; i < D; ++i) edge[i] = b.position[i] - a.position[i];
    const Pack length = squared_norm(edge);
    const Mask two = length > S(0);
    Pack scale = 0, share = 0;
    where(two, scale) = S(1) / length;
    where(two, share) = S(0.5);
    index_[0] = a.index, position_[0] = a.position, coefficient_[0] = S(1) - share;
    position_[1] = b.position, coefficient_[1] = share;
    where(two, index_[1]) = b.index;
    for (int i = 0; i < D; ++i) {
      gradient_[1][i] = edge[i] * scale;
      gradient_[0][i] = -gradient_[1][i];
    }
    return a.sum < std::numeric_limits<S>::infinity();
  }

  // Does GrowingSupport::enter in the active lanes.
  void enter(const Farthest& p, const Point& center, const Pack& far, Pack excess, const Mask& active) {
    Point offset, normal;
    for (int i = 0; i < D; ++i) offset[i] = p.position[i] - center[i];
    std::array<Pack, D + 1> share;
    Mask full(true);
    for (int k = 0; k <= D; ++k) {
      share[k] = coefficient_[k] + dot(gradient_[k], offset);
      full = full && index_[k] >= S(0);
    }
    normal = combine(position_, share);
    for (int i = 0; i < D; ++i) normal[i] = p.position[i] - normal[i];
    Pack squared_length = squared_norm(normal), entered = 0;
    const Mask flat = full || squared_length <= S(noise * noise) * far;
    for (int i = 0; i < D; ++i) where(flat, normal[i]) = S(0);
    where(flat, squared_length) = S(0);
    Pack step = excess / (S(2) * squared_length);  // infinite in a flat lane
    for (int dropped = 0; dropped <= D; ++dropped) {
      Pack shortest = step, left = S(-1);
      for (int k = 0; k <= D; ++k) {
        const Pack until = coefficient_[k] / share[k];
        const Mask first = share[k] > S(0) && until < shortest;
        where(first, shortest) = until;
        where(first, left) = S(k);
      }
      const Mask drops = active && left >= S(0);
      if (none_of(drops)) break;
      drop(drops, left, shortest, share, normal);
      where(drops, entered) = entered + shortest;
      where(drops, excess) = excess - S(2) * shortest * squared_length;
      where(drops, squared_length) = squared_norm(normal);
      where(drops, step) = excess / (S(2) * squared_length);
    }
    Mask open = active;
    const Pack scale = S(1) / squared_length;
    for (int i = 0; i < D; ++i) normal[i] *= scale;
    for (int k = 0; k <= D; ++k) {
      where(active, coefficient_[k]) = max(coefficient_[k] - step * share[k], Pack(S(0)));  // a NaN stays
      for (int i = 0; i < D; ++i) where(active, gradient_[k][i]) = gradient_[k][i] - normal[i] * share[k];
      const Mask here = open && index_[k] < S(0);
      where(here, index_[k]) = p.index;
      where(here, coefficient_[k]) = entered + step;
      for (int i = 0; i < D; ++i) {
        where(here, position_[k][i]) = p.position[i];
        where(here, gradient_[k][i]) = normal[i];
      }
      open = open && !here;
    }
  }

  // Does GrowingSupport::move_and_drop, and corrects the normal.
  void drop(const Mask& drops, const Pack& left, const Pack& step, std::array<Pack, D + 1>& share, Point& normal) {
    Point gradient;
    Pack gone = 0;
    for (int i = 0; i < D; ++i) gradient[i] = S(0);
    for (int k = 0; k <= D; ++k) {
      where(drops, coefficient_[k]) = max(Pack(S(0)), coefficient_[k] - step * share[k]);
      const Mask here = drops && left == S(k);
      where(here, gone) = share[k];
      for (int i = 0; i < D; ++i) where(here, gradient[i]) = gradient_[k][i];
    }
    Pack scale = 0;
    where(drops, scale) = S(1) / squared_norm(gradient);
    for (int k = 0; k <= D; ++k) {
      const Pack common = dot(gradient_[k], gradient) * scale;
      share[k] -= gone * common;
      for (int i = 0; i < D; ++i) gradient_[k][i] -= gradient[i] * common;
      const Mask here = drops && left == S(k);
      where(here, share[k]) = S(0);
      where(here, coefficient_[k]) = S(0);
      where(here, index_[k]) = S(-1);
      for (int i = 0; i < D; ++i) {
        where(here, gradient_[k][i]) = S(0);
        where(here, position_[k][i]) = S(0);
      }
    }
    for (int i = 0; i < D; ++i) normal[i] += gradient[i] * (gone * scale);
  }

  std::span<const Point> points_;
  std::array<Pack, D + 1> index_, coefficient_;
  std::array<Point, D + 1> position_, gradient_;
};

// points is not empty. Lanes that do not converge are solved again, one by one, as few_points_ball does. So each lane has the
// properties that are stated there. Two lanes of a double are slower than one cloud after the other; eight are twice as fast or
// better.
template <class Pack, int D>
SmallestBallPack<Pack, D> few_points_balls(std::span<const PackPoint<Pack, D>> points) {
  using S = typename Pack::value_type;
  auto out = FewPointsPacks<Pack, D>(points).solve();
  if (all_of(out.converged)) return out;
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    if (out.converged[lane]) continue;
    std::vector<Vec<S, D>> cloud(points.size());
    for (std::size_t j = 0; j < points.size(); ++j)
      for (int i = 0; i < D; ++i) cloud[j][i] = points[j][i][lane];
    const SmallestBall<S, D> ball = few_points_ball<S, D>(cloud);
    for (int i = 0; i < D; ++i) out.center[i][lane] = ball.center[i];
    out.squared_radius[lane] = ball.squared_radius;
    for (int k = 0; k <= D; ++k) {
      out.support[k][lane] = k < ball.support_size ? S(ball.support[k]) : S(-1);
      out.coefficients[k][lane] = k < ball.support_size ? ball.coefficients[k] : S(0);
    }
    out.converged[lane] = ball.converged;
  }
  return out;
}

}  // namespace refitlab
