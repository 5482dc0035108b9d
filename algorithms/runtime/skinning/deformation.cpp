// SPDX-License-Identifier: MIT
#include "algorithms/runtime/skinning/deformation.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Returns the quaternion of a rotation's matrix [Shepperd 1978]. It is computed from the greatest of its numbers.
Quaternion<double> quaternion_of(const Eigen::Matrix3d& m) {
  const double trace = m.trace();
  int greatest = 0;  // of the trace and the diagonal
  double most = trace;
  for (int i = 0; i < 3; ++i)
    if (m(i, i) > most) most = m(i, i), greatest = i + 1;
  Quaternion<double> q;
  if (greatest == 0) {
    q = {1 + trace, m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
  } else {
    const int i = greatest - 1, j = (i + 1) % 3, k = (i + 2) % 3;
    q[0] = m(k, j) - m(j, k);
    q[1 + i] = 1 + m(i, i) - m(j, j) - m(k, k);
    q[1 + j] = m(j, i) + m(i, j);
    q[1 + k] = m(k, i) + m(i, k);
  }
  return q / norm(q);
}

}  // namespace

void check_deformation(const SkinnedMesh& mesh, const Deformation& deformation) {
  const DefaultFloatEnvironment environment;
  if (!deformation.scales.empty()) check_pose(mesh, deformation.scales);
  if (deformation.weights.empty()) return;
  if (static_cast<int>(deformation.weights.size()) != mesh.targets.count)
    throw ModelError(mesh.name, "pose",
                     "has " + std::to_string(deformation.weights.size()) + " weights for " + std::to_string(mesh.targets.count) +
                         " morph targets");
  double sum = 0;
  for (std::size_t k = 0; k < deformation.weights.size(); ++k) {
    if (!std::isfinite(deformation.weights[k]))
      throw ModelError(mesh.name, "pose", "its weight of morph target " + std::to_string(k) + " is not finite");
    sum += std::abs(deformation.weights[k]);
  }
  if (!(sum <= largest_stretch)) throw ModelError(mesh.name, "pose", "its weights of morph targets sum to more than 1e4");
}

SkinningPalette<double> make_scale_palette(const SkinnedMesh& mesh, const JointSets& sets, const AffinePose& scales) {
  return scales.empty() ? SkinningPalette<double>() : make_skinning_palette(mesh, sets, scales);
}

SplitJoint split(const AffineMap<double>& joint, const Point3& origin) {
  const DefaultFloatEnvironment environment;
  Eigen::Matrix3d a;
  a << joint.columns[0], joint.columns[1], joint.columns[2];
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  const Eigen::Matrix3d& v = svd.matrixV();
  if (u.determinant() * v.determinant() < 0) u.col(2) = -u.col(2);  // then the least singular value counts as negative
  const Quaternion<double> q = quaternion_of(u * v.transpose());
  // s is R^T A, made symmetric.
  SplitJoint out;
  Eigen::Matrix3d s;
  for (int j = 0; j < 3; ++j) s.col(j) = rotate<double>(conjugate(q), joint.columns[static_cast<std::size_t>(j)]);
  s = (0.5 * (s + s.transpose())).eval();
  for (int j = 0; j < 3; ++j) out.scale.columns[static_cast<std::size_t>(j)] = s.col(j);
  out.scale.offset = origin - s * origin;
  out.rigid.rotation = q;
  out.rigid.translation = apply(joint, origin) - rotate(q, origin);
  return out;
}

SplitPose split(const SkinnedMesh& mesh, const AffinePose& pose) {
  const DefaultFloatEnvironment environment;
  check_pose(mesh, pose);
  SplitPose out;
  for (std::size_t j = 0; j < pose.size(); ++j) {
    const SplitJoint joint = split(pose[j], mesh.joints[j].origin);
    out.pose.push_back(joint.rigid);
    out.scales.push_back(joint.scale);
  }
  return out;
}

}  // namespace refitlab
