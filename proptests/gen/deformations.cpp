// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/deformations.hpp"

#include <algorithm>

#include "proptests/gen/random_pose.hpp"

namespace proptests::gen {

using namespace refitlab;

namespace {

int below(int n, std::mt19937& random) { return static_cast<int>(random() % static_cast<unsigned>(n)); }

double extent_of(const SkinnedMesh& mesh) {
  double out = 0;
  for (const Point3& v : mesh.vertices) out = std::max(out, v.lpNorm<Eigen::Infinity>());
  return out;
}

Point3 direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

Point3 clamped(const Point3& p) {
  return p.cwiseMin(Point3::Constant(largest_coordinate)).cwiseMax(Point3::Constant(-largest_coordinate));
}

Point3 factors_of(JointKind kind, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.2, 2);
  const double a = uniform(random), b = uniform(random), c = uniform(random);
  switch (kind) {
    case JointKind::rigid: return {1, 1, 1};
    case JointKind::uniform: return {a, a, a};
    case JointKind::mirrored: return {-a, b, c};
    case JointKind::flat: return below(2, random) ? Point3(a, b, 0) : Point3(0, a, 0);
    case JointKind::extreme: return below(2, random) ? Point3(5e3, 1, 1e-3) : Point3(0, 1e-200, 3e-160);
    default: return {a, b, c};
  }
}

AffineMap<double> joint_of(const SkinnedMesh& mesh, std::size_t j, JointKind kind, bool turns, std::mt19937& random) {
  if (kind == JointKind::mixed) kind = static_cast<JointKind>(below(joint_kind_count - 1, random));
  const Point3 factors = factors_of(kind, random), &origin = mesh.joints[j].origin;
  // A shear is a scale along axes of its own.
  const Quaternion<double> own = kind == JointKind::shear ? random_rotation(random, 2) : identity_quaternion<double>();
  const Quaternion<double> turn = turns ? random_rotation(random, 1) : identity_quaternion<double>();
  AffineMap<double> out;
  for (int i = 0; i < 3; ++i) {
    const Point3 scaled = rotate<double>(conjugate(own), Point3::Unit(i)).cwiseProduct(factors);
    out.columns[static_cast<std::size_t>(i)] = rotate<double>(turn, rotate<double>(own, scaled));
  }
  const Point3 away = turns && below(2, random) ? Point3(direction(random) * extent_of(mesh)) : Point3(0, 0, 0);
  out.offset = clamped(origin + away - turned_by(out, origin));
  return out;
}

}  // namespace

void add_targets(SkinnedMesh& mesh, std::mt19937& random) {
  const double extent = extent_of(mesh);
  mesh.targets = {below(6, random), {}};
  if (mesh.targets.count == 0) return;
  mesh.targets.of_vertex.resize(mesh.vertices.size());
  for (int t = 0; t < mesh.targets.count; ++t) {
    const double size = std::array{0., 0.01, 0.3, 1., 10.}[static_cast<std::size_t>(below(5, random))] * extent;
    const int every = 1 + below(3, random);
    const Point3 common = direction(random) * size;
    // All vertices move in the same direction.
    const bool is_common = below(3, random) == 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      if (below(every, random) == 0)
        mesh.targets.of_vertex[v].push_back({t, clamped(is_common ? common : Point3(direction(random) * size))});
  }
}

std::vector<double> random_weights(const SkinnedMesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> out;
  for (int t = 0; t < mesh.targets.count; ++t) {
    const double some = unit(random);
    out.push_back(std::array{0., 1., some, some, -some, 3 * some - 1, 1000 * some}[static_cast<std::size_t>(below(7, random))]);
  }
  return out;
}

AffinePose random_affine_pose(const SkinnedMesh& mesh, JointKind kind, std::mt19937& random) {
  AffinePose out;
  for (std::size_t j = 0; j < mesh.joints.size(); ++j) out.push_back(joint_of(mesh, j, kind, true, random));
  return out;
}

AffinePose random_scales(const SkinnedMesh& mesh, JointKind kind, std::mt19937& random) {
  AffinePose out;
  for (std::size_t j = 0; j < mesh.joints.size(); ++j) out.push_back(joint_of(mesh, j, kind, false, random));
  return out;
}

}  // namespace proptests::gen
