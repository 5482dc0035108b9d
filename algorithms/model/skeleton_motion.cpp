// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/skeleton_motion.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "algorithms/model/channel_value.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// This bounds the Frobenius norm of M^T M - I for a matrix whose columns were made unit vectors.
constexpr double orthogonality_tolerance = 1e-5;

// Returns the orthogonal factor of the polar decomposition of a matrix within rigidity_tolerance of a rotation. Each step of
// Newton's iteration squares the defect, so that four steps leave rounding only.
Eigen::Matrix3d nearest_rotation(Eigen::Matrix3d m) {
  for (int step = 0; step < 4; ++step) m = 0.5 * (m + m.inverse().transpose()).eval();
  return m;
}

double defect_of(const Eigen::Matrix4d& matrix) {
  const Eigen::Matrix3d m = matrix.topLeftCorner<3, 3>();
  return (m.transpose() * m - Eigen::Matrix3d::Identity()).norm();
}

bool is_proper(const Eigen::Matrix4d& matrix) { return matrix.allFinite() && matrix.topLeftCorner<3, 3>().determinant() > 0; }

// Returns why m, which is not within rigidity_tolerance of a rotation, is refused.
std::string reason_against(const Eigen::Matrix3d& m) {
  if (!m.allFinite()) return "the skin matrix is not finite";
  const Eigen::Vector3d s = m.jacobiSvd().singularValues();
  std::ostringstream text;
  if (s[0] - s[2] > 1e-3 * s[0]) text << "the skin matrix shears or scales unevenly, by " << s[2] << " to " << s[0];
  else if (m.determinant() < 0) text << "the skin matrix mirrors";
  else text << "the skin matrix scales by " << s[1];
  text << " (relative to the other joints in the first pose); only rotations with one constant scale are supported";
  return text.str();
}

std::vector<Eigen::Matrix4d> local_transforms(const std::vector<SceneNode>& nodes, const Animation& motion, double time,
                                              Side side) {
  std::vector<Eigen::Matrix4d> locals;
  for (const SceneNode& node : nodes) locals.push_back(node.local);
  for (const NodeTrack& track : motion.tracks) locals[track.node] = matrix_of(transform_at(track, time, side));
  return locals;
}

template <class Value>
void collect_times(const Channel<Value>& channel, std::vector<double>& times) {
  for (const auto& key : channel.keys) times.push_back(key.time);
}

}  // namespace

Eigen::Matrix4d matrix_of(const NodeTransform& transform) {
  const DefaultFloatEnvironment environment;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = transform.rotation.toRotationMatrix() * transform.scale.asDiagonal();
  matrix.topRightCorner<3, 1>() = transform.translation;
  return matrix;
}

std::optional<NodeTransform> parts_of(const SceneNode& node) {
  const DefaultFloatEnvironment environment;
  if (node.rest) return node.rest;
  Eigen::Matrix3d linear = node.local.topLeftCorner<3, 3>();
  Eigen::Vector3d scale = linear.colwise().norm();
  if (linear.determinant() < 0) scale[0] = -scale[0];
  linear = linear * scale.cwiseInverse().asDiagonal();
  if (!((linear.transpose() * linear - Eigen::Matrix3d::Identity()).norm() < orthogonality_tolerance)) return std::nullopt;
  return NodeTransform{node.local.topRightCorner<3, 1>(), scale, Eigen::Quaterniond(linear).normalized()};
}

NodeTransform transform_at(const NodeTrack& track, double time, Side side) {
  return {value_at(track.positions, time, side), value_at(track.scales, time, side), value_at(track.rotations, time, side)};
}

std::vector<Eigen::Matrix4d> global_transforms(const std::vector<SceneNode>& nodes, std::vector<Eigen::Matrix4d> locals) {
  const DefaultFloatEnvironment environment;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].parent >= 0) locals[i] = locals[nodes[i].parent] * locals[i];
  return locals;
}

std::vector<Eigen::Matrix4d> global_transforms(const std::vector<SceneNode>& nodes, const Animation& motion, double time,
                                               Side side) {
  return global_transforms(nodes, local_transforms(nodes, motion, time, side));
}

std::vector<Eigen::Matrix4d> skin_matrices(const BoundSkeleton& skeleton, const std::vector<Eigen::Matrix4d>& locals) {
  const DefaultFloatEnvironment environment;
  const auto globals = global_transforms(skeleton.nodes, locals);
  std::vector<Eigen::Matrix4d> out;
  for (const BoundJoint& j : skeleton.joints) out.push_back(globals[j.node] * j.offset);
  return out;
}

std::vector<Eigen::Matrix4d> skin_matrices(const BoundSkeleton& skeleton, const Animation& motion, double time, Side side) {
  return skin_matrices(skeleton, local_transforms(skeleton.nodes, motion, time, side));
}

AffinePose affine_pose(const BoundSkeleton& skeleton, const Animation& motion, double time) {
  const DefaultFloatEnvironment environment;
  AffinePose out;
  for (const Eigen::Matrix4d& m : skin_matrices(skeleton, motion, time))
    out.push_back({{m.block<3, 1>(0, 0), m.block<3, 1>(0, 1), m.block<3, 1>(0, 2)}, m.topRightCorner<3, 1>()});
  return out;
}

Eigen::VectorXd weights_at(const WeightTrack& track, double time, Side side) {
  const DefaultFloatEnvironment environment;
  return value_at(track.weights, time, side);
}

double rigidity_defect(const std::vector<Eigen::Matrix4d>& skin_matrices) {
  const DefaultFloatEnvironment environment;
  double out = 0;
  for (const Eigen::Matrix4d& matrix : skin_matrices) {
    if (!is_proper(matrix)) return std::numeric_limits<double>::infinity();
    out = std::max(out, defect_of(matrix));
  }
  return out;
}

Eigen::Matrix4d common_factor(const BoundSkeleton& skeleton, const Animation& motion, double time) {
  std::vector<double> scales;  // negative for a mirror
  for (const Eigen::Matrix4d& m : skin_matrices(skeleton, motion, time)) {
    const double determinant = m.topLeftCorner<3, 3>().determinant();
    if (std::isfinite(determinant)) scales.push_back(std::cbrt(determinant));
  }
  if (scales.empty()) return Eigen::Matrix4d::Identity();  // pose() has more to say
  const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
  std::nth_element(scales.begin(), middle, scales.end());
  const double scale = std::abs(std::abs(*middle) - 1) < 1e-5 ? 1 : std::abs(*middle);
  return Eigen::Vector4d(*middle < 0 ? -scale : scale, scale, scale, 1).asDiagonal();
}

PosedSkeleton rigid_pose(const BoundSkeleton& skeleton, const std::vector<Eigen::Matrix4d>& skin_matrices,
                         const std::string& clip, const std::string& when) {
  const DefaultFloatEnvironment environment;
  PosedSkeleton out{{}, 0};
  for (std::size_t j = 0; j < skin_matrices.size(); ++j) {
    const BoundJoint& joint = skeleton.joints[j];
    const Eigen::Matrix3d m = skin_matrices[j].topLeftCorner<3, 3>();
    const double defect = defect_of(skin_matrices[j]);
    if (!(defect <= rigidity_tolerance && is_proper(skin_matrices[j])))
      throw ModelError(skeleton.file, (clip.empty() ? "" : "clip '" + clip + "', ") + ("joint '" + joint.name + "', " + when),
                       reason_against(m));
    const Eigen::Quaterniond turn = Eigen::Quaterniond(nearest_rotation(m)).normalized();
    Quaternion<double> q(turn.w(), turn.x(), turn.y(), turn.z());
    const double side = joint.parent < 0 ? q[0] : dot(q, out.pose[joint.parent].rotation);
    if (side < 0) q = -q;
    out.pose.push_back({q, skin_matrices[j].topRightCorner<3, 1>()});
    out.rigidity_defect = std::max(out.rigidity_defect, defect);
  }
  return out;
}

PosedSkeleton pose(const BoundSkeleton& skeleton, const Animation& motion, double time, Side side) {
  std::ostringstream when;
  when << "time " << time << " s";
  return rigid_pose(skeleton, skin_matrices(skeleton, motion, time, side), motion.name, when.str());
}

std::vector<double> key_times(const Animation& motion, std::size_t limit) {
  std::vector<double> times = {0, motion.duration};
  for (const NodeTrack& track : motion.tracks) {
    collect_times(track.positions, times);
    collect_times(track.rotations, times);
    collect_times(track.scales, times);
  }
  for (const WeightTrack& track : motion.weight_tracks) collect_times(track.weights, times);
  std::erase_if(times, [&](double t) { return t < 0 || t > motion.duration; });
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  if (times.size() <= limit) return times;
  std::vector<double> thinned;
  for (std::size_t i = 0; i < limit; ++i) thinned.push_back(times[i * (times.size() - 1) / (limit - 1)]);
  return thinned;
}

std::vector<double> times_at_rate(double rate, double end) {
  const DefaultFloatEnvironment environment;
  std::vector<double> times;
  for (int i = 0; i / rate < end; ++i) times.push_back(i / rate);
  times.push_back(end);
  return times;
}

}  // namespace refitlab
