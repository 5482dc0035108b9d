// SPDX-License-Identifier: MIT
#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/runtime/balls/ball_about.hpp"
#include "algorithms/runtime/balls/scaling.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using Balls = std::span<const Ball3<double>>;

double reach(const Vec<double, 3>& center, const Ball3<double>& ball) {
  return norm<double, 3>(ball.center - center) + ball.radius;
}

std::size_t farthest_from(const Vec<double, 3>& center, Balls balls) {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < balls.size(); ++i)
    if (reach(center, balls[i]) > reach(center, balls[farthest])) farthest = i;
  return farthest;
}

// Returns the greatest radius or coordinate relative to the first center.
double size_of(Balls balls) {
  double size = 0;
  for (const auto& b : balls) size = std::max({size, b.radius, (b.center - balls[0].center).cwiseAbs().maxCoeff()});
  return size;
}

// Appends the centers, in the flat through the balls' centers, from which all balls have the same reach. With d_k = c_k - c_0, a
// center c_0 + y has the reach R from ball k, for R >= r_k, if |y - d_k| = R - r_k. The difference of the squares of this and of
// |y| = R - r_0 is linear in y and R, so that y = u + R v, and |y| = R - r_0 is a quadratic equation in R.
void add_equal_reach_centers(const std::vector<Ball3<double>>& balls, std::vector<Vec<double, 3>>& centers) {
  const Ball3<double>& first = balls[0];
  if (balls.size() == 1) return centers.push_back(first.center);
  const auto others = static_cast<Eigen::Index>(balls.size() - 1);
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> d(others, 3);
  Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 3, 2> right(others, 2);
  for (Eigen::Index k = 0; k < others; ++k) {
    const Ball3<double>& b = balls[k + 1];
    const Vec<double, 3> to = b.center - first.center;
    d.row(k) = to.transpose();
    right(k, 0) = (to.squaredNorm() + (first.radius - b.radius) * (first.radius + b.radius)) / 2;
    right(k, 1) = b.radius - first.radius;
  }
  const Eigen::Matrix<double, 3, 2> solved = d.completeOrthogonalDecomposition().solve(right);
  const Vec<double, 3> u = solved.col(0), v = solved.col(1);
  // The radius satisfies (1 - v.v) R^2 - 2 (r_0 + u.v) R + r_0^2 - u.u = 0.
  const double a = 1 - v.squaredNorm(), half_b = first.radius + u.dot(v), c = sq(first.radius) - u.squaredNorm();
  const double root_of = std::sqrt(std::max(0.0, sq(half_b) - a * c)), larger = half_b + std::copysign(root_of, half_b);
  for (const double radius : {larger / a, c / larger})
    if (std::isfinite(radius)) centers.push_back(first.center + u + radius * v);
}

// The smallest ball of at most five balls has the same reach from some of them, at most four, and its center in the flat
// through theirs. All of these are tried, and whichever center has the smallest reach is taken: so a choice of balls for which
// the equations have no solution, or a wrong one by rounding, does no harm. support becomes the balls of the best choice.
Ball3<double> smallest_by_trial(Balls balls, std::vector<Ball3<double>>& support) {
  Ball3<double> best{balls[0].center, std::numeric_limits<double>::infinity()};
  std::vector<Vec<double, 3>> centers;
  for (unsigned chosen = 1; chosen < 1u << balls.size(); ++chosen) {
    std::vector<Ball3<double>> some;
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (chosen >> i & 1) some.push_back(balls[i]);
    if (some.size() > 4) continue;
    centers.clear();
    add_equal_reach_centers(some, centers);
    for (const auto& center : centers)
      if (const Ball3<double> ball = ball_about<double, 3>(center, balls); ball.radius < best.radius) best = ball, support = some;
  }
  return best;
}

}  // namespace

Ball3<double> smallest_ball_of_balls(Balls balls) {
  const DefaultFloatEnvironment environment;
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  for (const auto& b : balls)
    if (!b.center.allFinite() || !(b.radius >= 0) || !std::isfinite(b.radius))
      return {Vec<double, 3>::Constant(undefined), undefined};
  if (const int scaling = scaling_of(size_of(balls)); scaling != 0) {
    std::vector<Ball3<double>> of_size_one;
    for (const auto& b : balls)
      of_size_one.push_back(
          {times_power_of_two(Vec<double, 3>(b.center - balls[0].center), -scaling), std::scalbn(b.radius, -scaling)});
    const Vec<double, 3> center = smallest_ball_of_balls(of_size_one).center;
    return ball_about<double, 3>(balls[0].center + times_power_of_two(center, scaling), balls);
  }
  // The ball of a few grows by the ball that is farthest from it, until there is none outside. Each radius is greater than the
  // last, so no support comes twice. If rounding hides the growth, the search ends too.
  std::vector<Ball3<double>> few{balls[farthest_from(balls[0].center, balls)]};
  Ball3<double> best{few[0].center, std::numeric_limits<double>::infinity()};
  for (double last = -1;;) {
    std::vector<Ball3<double>> support;
    const Ball3<double> of_few = smallest_by_trial(few, support);
    const std::size_t farthest = farthest_from(of_few.center, balls);
    if (const double radius = reach(of_few.center, balls[farthest]); radius < best.radius) best = {of_few.center, radius};
    if (of_few.radius <= last || best.radius <= of_few.radius) return best;
    last = of_few.radius;
    few = std::move(support);
    few.push_back(balls[farthest]);
  }
}

}  // namespace refitlab
