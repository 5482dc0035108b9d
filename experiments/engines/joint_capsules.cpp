// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/joint_capsules.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "algorithms/runtime/packs/float_above.hpp"
#include "experiments/engines/weighted_radii.hpp"

namespace refitlab {
namespace {

constexpr float lost_of_capsules = 0x1p-16f, stretch_of_joints = 1e-5f;
constexpr int tried_radii = 24;

// Returns half the mean width of a capsule over all directions, which is its size here.
double half_width(const JointCapsule& capsule) { return capsule.radius + norm<double, 3>(capsule.ends[1] - capsule.ends[0]) / 4; }

// Returns the capsule of the given radius about a line through the middle of the points. Its axis is no longer than need be. Its
// radius is less than 0 if points are farther from the line.
JointCapsule capsule_along(const std::vector<Point3>& points, const Point3& middle, const Point3& axis, double radius) {
  double first = infinite, last = -infinite;
  for (const Point3& p : points) {
    const double along = dot<double, 3>(p - middle, axis);
    const double beside = squared_norm<double, 3>(p - middle - along * axis);
    if (beside > radius * radius) return {};
    const double reach = std::sqrt(radius * radius - beside);
    first = std::min(first, along + reach), last = std::max(last, along - reach);
  }
  if (first > last) first = last = (first + last) / 2;
  return {{Point3(middle + first * axis), Point3(middle + last * axis)}, radius};
}

// Returns the smallest of some capsules around the points.
JointCapsule capsule_around(const std::vector<Point3>& points) {
  Point3 mean = Point3::Zero();
  for (const Point3& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point3& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  Point3 low = Point3::Constant(infinite), high = -low;
  for (const Point3& p : points) low = low.cwiseMin(axes.transpose() * p), high = high.cwiseMax(axes.transpose() * p);
  const Point3 middle = axes * ((low + high) / 2);
  double farthest = 0;
  for (const Point3& p : points) farthest = std::max(farthest, norm<double, 3>(p - middle));
  JointCapsule best{{middle, middle}, farthest};
  for (int a = 0; a < 3; ++a)
    for (int i = 1; i <= tried_radii; ++i)
      if (const JointCapsule c = capsule_along(points, middle, axes.col(a), farthest * i / tried_radii);
          c.radius >= 0 && half_width(c) < half_width(best))
        best = c;
  return best;
}

}  // namespace

double distance_from_axis(const JointCapsule& capsule, const Point3& point) {
  const Point3 axis = capsule.ends[1] - capsule.ends[0], arm = point - capsule.ends[0];
  const double squared = squared_norm<double, 3>(axis);
  const double along = squared > 0 ? std::clamp(dot<double, 3>(arm, axis) / squared, 0.0, 1.0) : 0;
  return norm<double, 3>(arm - along * axis);
}

std::vector<JointCapsule> fit_capsules(const SkinnedMesh& mesh) {
  const DefaultFloatEnvironment environment;
  std::vector<JointCapsule> capsules;
  for (const auto& points : own_vertices(mesh, 0.5)) {
    capsules.push_back(points.empty() ? JointCapsule{{Point3::Zero(), Point3::Zero()}, -1} : capsule_around(points));
    for (Point3& end : capsules.back().ends) end = end.cast<float>().cast<double>();
  }
  std::vector<std::vector<WeightedDistance>> inequalities;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    auto& own = inequalities.emplace_back();
    for (const Influence& i : mesh.influences[v])
      own.push_back({i.joint, i.weight, distance_from_axis(capsules[i.joint], mesh.vertices[v])});
  }
  const std::vector<double> radii = weighted_radii(inequalities, std::vector<double>(capsules.size()));
  for (std::size_t j = 0; j < capsules.size(); ++j)
    if (capsules[j].radius >= 0) capsules[j].radius = radii[j];
  return capsules;
}

JointCapsules::JointCapsules(const SkinnedMesh& mesh, const std::vector<JointCapsule>& capsules)
    : numbers_(capsule_numbers, mesh.joints.size()) {
  const DefaultFloatEnvironment environment;
  for (int j = 0; j < numbers_.padded_count(); ++j) numbers_.at(6, j) = extent_of_nothing;
  for (std::size_t j = 0; j < capsules.size(); ++j) {
    const JointCapsule& c = capsules[j];
    if (c.radius < 0) continue;
    double farthest = 0;
    for (int end = 0; end < 2; ++end) {
      for (int i = 0; i < 3; ++i) numbers_.at(3 * end + i, static_cast<int>(j)) = static_cast<float>(c.ends[end][i]);
      farthest = std::max(farthest, norm<double, 3>(c.ends[end]));
    }
    numbers_.at(6, static_cast<int>(j)) = float_above(c.radius * (1 + stretch_of_joints) + 2.1 * lost_of_capsules * farthest);
  }
}

Box<float> JointCapsules::box(const JointMatrices& matrices, Target target) const {
  const DefaultFloatEnvironment environment;
  float out[6];
  joint_kernels(target).capsules(matrices.data(), numbers_.data(), numbers_.blocks(), 2 * lost_of_capsules, out);
  return box_of_numbers(out);
}

}  // namespace refitlab
