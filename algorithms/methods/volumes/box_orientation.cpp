// SPDX-License-Identifier: MIT
#include "algorithms/methods/volumes/box_orientation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "algorithms/runtime/balls/scaling.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using Point = Vec<double, 3>;

// Returns the orientation of a right-handed orthonormal frame, which has an axis in each column.
Quaternion<double> orientation_of(const Eigen::Matrix3d& frame) {
  const Eigen::Quaterniond q(frame);
  return {q.w(), q.x(), q.y(), q.z()};
}

Quaternion<double> principal_axes(std::span<const Ball3<double>> balls) {
  Point mean = Point::Zero();
  for (const auto& b : balls) mean += b.center;
  mean /= static_cast<double>(balls.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& b : balls) covariance += (b.center - mean) * (b.center - mean).transpose();
  Eigen::Matrix3d frame = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  if (frame.determinant() < 0) frame.col(0) *= -1;
  return orientation_of(frame);
}

// Returns the orientation by the side from a to b and the normal of a triangle, or no rotation if these are too short to have a
// direction.
Quaternion<double> side_frame(const Point& a, const Point& b, const Point& normal) {
  const Point side = b - a;
  if (!(side.norm() > 0 && normal.norm() > 1e-12 * side.squaredNorm())) return identity_quaternion<double>();
  Eigen::Matrix3d frame;
  frame.col(0) = side.normalized();
  frame.col(1) = (normal - frame.col(0) * normal.dot(frame.col(0))).normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return orientation_of(frame);
}

// Takes the centers that reach farthest along some directions and their opposites, and returns the two that are farthest apart.
std::pair<Point, Point> long_side(std::span<const Ball3<double>> balls) {
  const Point directions[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};
  std::pair<Point, Point> best{balls[0].center, balls[0].center};
  for (const Point& d : directions) {
    const auto [low, high] = std::minmax_element(balls.begin(), balls.end(),
                                                 [&](const auto& a, const auto& b) { return a.center.dot(d) < b.center.dot(d); });
    if ((high->center - low->center).squaredNorm() > (best.second - best.first).squaredNorm()) best = {low->center, high->center};
  }
  return best;
}

}  // namespace

std::array<Quaternion<double>, 5> box_orientations(std::span<const Ball3<double>> balls) {
  const DefaultFloatEnvironment environment;
  double size = 0;
  for (const auto& b : balls) size = std::max(size, (b.center - balls[0].center).cwiseAbs().maxCoeff());
  if (const int scaling = scaling_of(size); scaling != 0) {
    std::vector<Ball3<double>> of_size_one;
    for (const auto& b : balls) of_size_one.push_back({times_power_of_two(Point(b.center - balls[0].center), -scaling), 0});
    return box_orientations(of_size_one);
  }
  const auto ends = long_side(balls);
  const Point a = ends.first, b = ends.second, side = b - a;
  const auto squared_area = [&](const Ball3<double>& ball) { return side.cross(ball.center - a).squaredNorm(); };
  const Point c = std::max_element(balls.begin(), balls.end(), [&](const auto& p, const auto& q) {
                    return squared_area(p) < squared_area(q);
                  })->center;
  const Point normal = side.cross(c - a);
  return {identity_quaternion<double>(), principal_axes(balls), side_frame(a, b, normal), side_frame(b, c, normal),
          side_frame(c, a, normal)};
}

}  // namespace refitlab
