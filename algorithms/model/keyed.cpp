// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/keyed.hpp"

#include <memory>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr double most_keys = 1e7;

Eigen::Isometry3d isometry(const RigidTransform<double>& c) {
  const Eigen::Quaterniond q(c.rotation[0], c.rotation[1], c.rotation[2], c.rotation[3]);
  return Eigen::Translation3d(c.translation) * Eigen::Isometry3d(q);
}

BoundSkeleton skeleton_of(const SkinnedMesh& mesh) {
  BoundSkeleton out{mesh.name, {}, {}};
  for (const Joint& joint : mesh.joints) {
    const int index = static_cast<int>(out.joints.size());
    const Point3 parent = joint.parent < 0 ? Point3(0, 0, 0) : mesh.joints[joint.parent].origin;
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity(), offset = local;
    local.topRightCorner<3, 1>() = joint.origin - parent;
    offset.topRightCorner<3, 1>() = -joint.origin;
    out.nodes.push_back({joint.name, joint.parent, local, index});
    out.joints.push_back({joint.name, index, joint.parent, offset});
  }
  return out;
}

Animation keyed_clip(const Clip& clip, const SkinnedMesh& mesh, double rate) {
  if (!(rate > 0 && clip.duration * rate < most_keys))
    throw ModelError(mesh.name, "clip '" + clip.name + "'", "cannot have " + std::to_string(rate) + " keys a second");
  Animation out{clip.name, clip.duration, {}};
  for (std::size_t j = 0; j < mesh.joints.size(); ++j)
    out.tracks.push_back({static_cast<int>(j), {}, {}, {{{0, Eigen::Vector3d::Ones()}}}});
  std::vector<Eigen::Isometry3d> globals(mesh.joints.size());
  for (std::size_t k = 0;; ++k) {
    const double time = std::min(static_cast<double>(k) / rate, clip.duration);
    const Pose pose = clip.sample(time);
    for (std::size_t j = 0; j < mesh.joints.size(); ++j) {
      const Joint& joint = mesh.joints[j];
      globals[j] = isometry(pose[j]) * Eigen::Translation3d(joint.origin);
      const Eigen::Isometry3d local = joint.parent < 0 ? globals[j] : globals[joint.parent].inverse() * globals[j];
      NodeTrack& track = out.tracks[j];
      track.positions.keys.push_back({time, local.translation()});
      track.rotations.keys.push_back({time, Eigen::Quaterniond(local.linear()).normalized()});
    }
    if (time >= clip.duration) return out;
  }
}

}  // namespace

Model keyed(const Model& model, double rate) {
  const DefaultFloatEnvironment environment;
  Model out{static_cast<const SkinnedMesh&>(model)};
  out.skeleton = skeleton_of(model);
  const auto skeleton = std::make_shared<const BoundSkeleton>(out.skeleton);
  for (const Clip& clip : model.clips) {
    const Animation motion = keyed_clip(clip, model, rate);
    out.clips.push_back(
        {motion.name, motion.duration, [skeleton, motion](double time) { return pose(*skeleton, motion, time).pose; }, motion});
  }
  return out;
}

}  // namespace refitlab
