// SPDX-License-Identifier: MIT
// Computes the smallest enclosing ball of few balls of R^3 by pivoting, as in few_points_ball.hpp.
//
// [c, R] encloses all balls if no power ||c_k - c||^2 + r_k (2 R - r_k) exceeds R^2. For a given R the center with the smallest
// greatest power is found by the pivots of the smallest ball of points: a constant is added to each squared distance. So a pivot
// is one of points, and then R grows to where the power of the support, of which R makes a quadratic polynomial, is R^2. All
// radii are less the smallest of them: equal balls are points.
#pragma once

#include "algorithms/runtime/balls/few_points_ball.hpp"
#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"

namespace refitlab {

// The certificate is that the center is a convex combination of the support's centers, and the support touches the ball from
// within.
struct SmallestBallOfBalls {
  Ball3<double> ball;                  // the radius is what encloses all balls as computed
  std::array<int, 4> support;          // indices of the balls, the first support_size of them
  std::array<double, 4> coefficients;  // of the combination: non-negative, sum 1
  int support_size = 0;                // 0: found by smallest_ball_of_balls, which shows no support
  int pivots = 0;
};

// A RadiusRange has the least, the greatest and the sum of some balls' radii.
struct RadiusRange {
  explicit RadiusRange(std::span<const Ball3<double>> balls) : least(balls[0].radius), greatest(balls[0].radius) {
    for (const auto& b : balls) {
      least = min_of(least, b.radius);
      greatest = max_of(greatest, b.radius);
      sum += b.radius;
    }
  }
  // Returns false if a radius is negative, infinite or NaN.
  bool is_defined() const { return least >= 0 && sum < std::numeric_limits<double>::infinity(); }
  double least, greatest, sum = 0;
};

// There are at most `most` balls, which is a power of two, so that everything lives on the stack.
template <int most>
class FewBalls {
 public:
  // balls is not empty, and range, which is that of their radii, is defined.
  FewBalls(std::span<const Ball3<double>> balls, const RadiusRange& range)
      : balls_(balls),
        range_(range),
        origin_(quad<double>(balls[0].center)) {}

  // The pivots end as soon as the radius is proved to be within 1 + slack of the smallest. Returns false if a center is not
  // finite, or if the result does not hold up.
  bool solve(double slack = 0) {
    const double near = 1 - 1 / sq(1 + slack);  // a guess at where that is: the powers are of the radii less the least
    const int a = fill_table();
    if (!is_defined_) return false;
    start(a, farthest_from(origin_ + position(a), range_.greatest - range_.least));
    for (; pivots_ < most_pivots; ++pivots_) {
      const Quad<double> center = support_.center();
      center_ = origin_ + center;
      const int farthest = farthest_from(center_, radius_);
      const Quad<double> p = position(farthest);
      const double far = power(p, farthest, center), low = power_of_support(center);
      if (far - low <= tolerance * far) return holds_up(center, slack);
      if (far - low <= near * far && holds_up(center, slack)) return true;
      if (support_.contains(farthest)) return false;
      if (!support_.enter(farthest, p, center, far - low, sq(noise) * far) || !grow()) return false;
    }
    return false;
  }

  SmallestBallOfBalls ball() const {
    SmallestBallOfBalls out{{vec<3>(center_), enclosing_radius_}, {}, {}, support_.size(), pivots_};
    for (int k = 0; k < support_.size(); ++k) {
      out.support[k] = support_.index(k);
      out.coefficients[k] = support_.coefficient(k);
    }
    return out;
  }

 private:
  static constexpr int most_pivots = 30 + most;
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double tolerance = 64 * epsilon;  // of the squared radius
  static constexpr double noise = 512 * epsilon;     // of a distance from the support's hull

  Quad<double> position(int i) const { return quad<double>(balls_[i].center) - origin_; }
  double radius(int i) const { return balls_[i].radius - range_.least; }
  double power(const Quad<double>& p, int i, const Quad<double>& center) const {
    return squared_norm(p - center) + radius(i) * (2 * radius_ - radius(i));
  }

  // Returns the power of the support. At this radius, the greatest power of the balls is no smaller from any center.
  double power_of_support(const Quad<double>& center) const {
    double sum = 0;
    for (int k = 0; k < support_.size(); ++k)
      sum += support_.coefficient(k) * power(support_.position(k), support_.index(k), center);
    return sum;
  }
  double radius_of_support() const {
    double sum = 0;
    for (int k = 0; k < support_.size(); ++k) sum += support_.coefficient(k) * radius(support_.index(k));
    return sum;
  }

  // The last ball stands twice if the number of balls is odd. Returns the index of the ball that is farthest from the first one's
  // center, more or less.
  int fill_table() {
    Farthest<double, most> farthest;
    Row<double, 2> sum{};
    const auto first = same_point_twice<3>(origin_);
    const double twice = 2 * (range_.greatest - range_.least);
    const int n = static_cast<int>(balls_.size());
    for (int i = 0; i < n; i += 2) {
      const Ball3<double>&a = balls_[i], &b = balls_[i + 1 < n ? i + 1 : i];
      centers_[i / 2] = two_points<double, 3>(a.center, b.center);
      const Row<double, 2> r = radii_[i / 2] = Row<double, 2>{a.radius, b.radius} - range_.least;
      const Row<double, 2> powers = squared_distances(centers_[i / 2], first) + r * (twice - r);
      sum += powers;
      farthest.see(powers);
    }
    is_defined_ = sum[0] + sum[1] < infinity;
    return farthest.index();
  }

  // Returns the index of the ball of greatest power. No radius is greater than the given one.
  int farthest_from(const Quad<double>& center, double radius) const {
    Farthest<double, most> farthest;
    const auto c = same_point_twice<3>(center);
    const double twice = 2 * radius;
    const int rows = (static_cast<int>(balls_.size()) + 1) / 2;
    for (int i = 0; i < rows; ++i) farthest.see(squared_distances(centers_[i], c) + radii_[i] * (twice - radii_[i]));
    return farthest.index();
  }

  // Starts with the smallest ball of two balls, or with the greatest ball alone if that is no smaller.
  void start(int a, int b) {
    const Quad<double> pa = position(a), pb = position(b);
    const double length = root(squared_norm(pb - pa)), between = (length + radius(a) + radius(b)) / 2;
    const bool pair = between > max_of(radius(a), radius(b)) && between >= range_.greatest - range_.least;
    if (pair) {
      radius_ = between;
      support_.start(a, pa, b, pb, (between - radius(a)) / length);
    } else {
      int greatest = 0;
      while (balls_[greatest].radius < range_.greatest) ++greatest;
      radius_ = radius(greatest);
      support_.start(greatest, position(greatest));
    }
  }

  // Grows the radius until it is that of the smallest ball of the support. The support's power at radius + x is
  // F + 2 rho x + ||v||^2 x^2, rho the mean of the radii by the coefficients, while the center moves along v.
  // If that is never (radius + x)^2, a ball leaves first.
  bool grow() {
    for (;;) {
      if (support_.size() == 1) return false;
      const Quad<double> center = support_.center();
      Quad<double> v = support_.gradient(0) * radius(support_.index(0));
      for (int k = 1; k < support_.size(); ++k) v = v + support_.gradient(k) * radius(support_.index(k));
      const double missing = power_of_support(center) - sq(radius_), slope = radius_ - radius_of_support();
      const double squared_root = sq(slope) + (1 - squared_norm(v)) * missing;
      const double step = squared_root < 0 ? infinity : missing / (slope + root(squared_root));
      if (!(step > 0)) return step <= 0;
      const double made = support_.move(v, step);
      radius_ += made;
      if (made == step) return made < infinity;
    }
  }

  // Finds the radius that encloses all, and compares it with what is proved.
  bool holds_up(const Quad<double>& center, double slack) {
    const Vec<double, 3> c = vec<3>(center_);
    double& far = enclosing_radius_ = 0;
    for (const auto& b : balls_) {
      // A root is needed only for balls that may be farther.
      const double squared = squared_distance(b.center, c);
      if (far <= b.radius || sq(far - b.radius) <= squared * (1 + 8 * epsilon)) far = max_of(far, root(squared) + b.radius);
    }
    const double rounding = tolerance * far + 4 * epsilon * max_of(c.cwiseAbs().maxCoeff(), range_.greatest);
    return far <= proved_radius(center) * (1 + slack) + rounding;
  }

  // Returns a radius that no ball around the support is below. It is the mean of the support's reach, by weights for which the
  // unit vectors from the balls to the center add up to 0 (all other centers are farther, on average, from where the balls
  // touch).
  double proved_radius(const Quad<double>& center) const {
    double weights = 0, sum = 0;
    for (int k = 0; k < support_.size(); ++k) {
      const double distance = root(squared_norm(support_.position(k) - center));
      const double weight = support_.coefficient(k) * distance;
      weights += weight;
      sum += weight * (distance + balls_[support_.index(k)].radius);
    }
    return support_.size() == 1 ? balls_[support_.index(0)].radius : sum / weights;
  }

  std::span<const Ball3<double>> balls_;
  RadiusRange range_;
  Quad<double> origin_, center_;
  double radius_, enclosing_radius_;  // less the least of the radii, and of the whole
  bool is_defined_;
  int pivots_ = 0;
  GrowingSupport<double, 3> support_;
  std::array<TwoPoints<double, 3>, most / 2> centers_;
  std::array<Row<double, 2>, most / 2> radii_;
};

// Returns the smallest ball of balls of one radius, from the smallest ball of their centers.
inline SmallestBallOfBalls as_ball_of_balls(const SmallestBall<double, 3>& centers, double radius) {
  SmallestBallOfBalls out{{centers.center, root(centers.squared_radius) + radius}, centers.support, centers.coefficients};
  out.support_size = centers.support_size, out.pivots = centers.steps;
  return out;
}

template <int most>
[[gnu::noinline]] SmallestBallOfBalls pivot_balls(std::span<const Ball3<double>> balls, double slack) {
  const RadiusRange range(balls);
  if (range.is_defined() && range.least == range.greatest) {
    if (balls.size() == 3) {
      const auto ball = three_points_ball(balls[0].center, balls[1].center, balls[2].center);
      if (ball.converged) return as_ball_of_balls(ball, range.least);
    }
    FewPoints<double, 3, most, Ball3<double>> points(balls);
    if (points.solve(slack)) return as_ball_of_balls(points.ball(), range.least);
  } else if (range.is_defined()) {
    FewBalls<most> few(balls, range);
    if (few.solve(slack)) return few.ball();
  }
  return {smallest_ball_of_balls(balls)};
}

// balls is not empty. This is made for up to 32 balls; up to 4096 are pivoted too, and more are left to smallest_ball_of_balls.
// The ball is smallest up to rounding, or at most 1 + slack times as large; the radius is then raised to what encloses all balls
// as computed. If one of the balls is undefined (not finite, or of negative radius), so is the result: all of it is NaN. With a
// slack, the certificate is that of the support's ball.
inline SmallestBallOfBalls few_balls_ball(std::span<const Ball3<double>> balls, double slack = 0) {
  if (balls.size() <= 32) return pivot_balls<32>(balls, slack);
  if (balls.size() <= 512) return pivot_balls<512>(balls, slack);
  if (balls.size() <= 4096) return pivot_balls<4096>(balls, slack);
  return {smallest_ball_of_balls(balls)};
}

// Returns the same ball without the certificate. For one ball or three points, which most nodes of a tree have, the certificate
// costs as much as the ball.
inline Ball3<double> few_balls_enclosing(std::span<const Ball3<double>> balls, double slack = 0) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (balls.size() == 1) {
    const Ball3<double>& b = balls[0];
    const double size = std::abs(b.center[0]) + std::abs(b.center[1]) + std::abs(b.center[2]) + b.radius;
    if (b.radius >= 0 && size < infinity) return b;
  } else if (balls.size() == 3 && balls[0].radius == balls[1].radius && balls[1].radius == balls[2].radius) {
    const auto points = three_points_ball(balls[0].center, balls[1].center, balls[2].center);
    const double radius = root(points.squared_radius) + balls[0].radius;
    if (balls[0].radius >= 0 && radius < infinity) return {points.center, radius};
  }
  return few_balls_ball(balls, slack).ball;
}

}  // namespace refitlab
