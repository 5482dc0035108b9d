// SPDX-License-Identifier: MIT
#include "algorithms/runtime/skinning/skinning_palette.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace refitlab {
namespace {

Point3 mean_origin(const SkinnedMesh& mesh, std::span<const int> joints) {
  Point3 sum = Point3::Zero();
  for (const int j : joints) sum += mesh.joints[j].origin;
  return sum / static_cast<double>(joints.size());
}

// Returns the origin of the joint that two neighbouring bones share. It is the joint of the set whose parent is in the set too,
// or the last one if there are several. For a set without neighbours Hejl's variant is not defined; the first joint's origin
// keeps it total.
Point3 shared_joint(const SkinnedMesh& mesh, std::span<const int> joints) {
  int shared = joints[0];
  for (const int j : joints)
    for (const int k : joints)
      if (mesh.joints[j].parent == k) shared = j;
  return mesh.joints[shared].origin;
}

[[noreturn]] void refuse(const SkinnedMesh& mesh, std::size_t joint, const char* reason) {
  throw ModelError(mesh.name, "pose, joint " + std::to_string(joint) + " (" + mesh.joints[joint].name + ")", reason);
}

}  // namespace

void check_joint_count(const SkinnedMesh& mesh, std::size_t count) {
  if (count != mesh.joints.size())
    throw ModelError(mesh.name, "pose",
                     "has " + std::to_string(count) + " transforms for " + std::to_string(mesh.joints.size()) + " joints");
}

void check_pose(const SkinnedMesh& mesh, const Pose& pose) {
  const DefaultFloatEnvironment environment;
  check_joint_count(mesh, pose.size());
  for (std::size_t j = 0; j < pose.size(); ++j) {
    if (!pose[j].rotation.allFinite() || !pose[j].translation.allFinite()) refuse(mesh, j, "its transform is not finite");
    if (pose[j].translation.lpNorm<Eigen::Infinity>() > largest_coordinate)
      refuse(mesh, j, "its translation is out of range, beyond 1e40");
    if (!(std::abs(squared_norm(pose[j].rotation) - 1) <= 1e-6))  // loose enough for rotations read from floats
      refuse(mesh, j, "its rotation is not a quaternion of unit length");
  }
}

void check_pose(const SkinnedMesh& mesh, const AffinePose& pose) {
  const DefaultFloatEnvironment environment;
  check_joint_count(mesh, pose.size());
  for (std::size_t j = 0; j < pose.size(); ++j) {
    double greatest = 0;
    bool is_finite = pose[j].offset.allFinite();
    for (const Point3& column : pose[j].columns) {
      is_finite = is_finite && column.allFinite();
      greatest = max_of(greatest, column.lpNorm<Eigen::Infinity>());
    }
    if (!is_finite) refuse(mesh, j, "its transform is not finite");
    if (pose[j].offset.lpNorm<Eigen::Infinity>() > largest_coordinate)
      refuse(mesh, j, "its translation is out of range, beyond 1e40");
    if (greatest > largest_stretch) refuse(mesh, j, "its matrix is out of range, beyond 1e4");
  }
}

Point3 center_prior(const SkinnedMesh& mesh, std::span<const int> joints, Skinning skinning) {
  const DefaultFloatEnvironment environment;
  return skinning == Skinning::hejl ? shared_joint(mesh, joints) : mean_origin(mesh, joints);
}

SkinningPalette<double> make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const Pose& pose,
                                              Skinning skinning) {
  SkinningPalette<double> palette;
  make_skinning_palette(mesh, sets, pose, skinning, palette);
  return palette;
}

void make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const Pose& pose, Skinning skinning,
                           SkinningPalette<double>& palette) {
  const DefaultFloatEnvironment environment;
  check_pose(mesh, pose);
  palette.clear();
  for (int s = 0; s < sets.count(); ++s) {
    const auto joints = sets.joints(s);
    const auto transforms = palette.append(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) transforms[i] = pose[joints[i]];
    make_signs_consistent(transforms);
    const Point3 prior = center_prior(mesh, joints, skinning);
    palette.complete(skinning == Skinning::hejl ? prior : rotation_center<double>(transforms, prior));
  }
}

SkinningPalette<double> make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const AffinePose& pose) {
  SkinningPalette<double> palette;
  make_skinning_palette(mesh, sets, pose, palette);
  return palette;
}

void make_skinning_palette(const SkinnedMesh& mesh, const JointSets& sets, const AffinePose& pose,
                           SkinningPalette<double>& palette) {
  const DefaultFloatEnvironment environment;
  check_pose(mesh, pose);
  palette.clear();
  std::vector<AffineMap<double>> maps;
  for (int s = 0; s < sets.count(); ++s) {
    maps.clear();
    for (const int j : sets.joints(s)) maps.push_back(pose[j]);
    palette.push_back_affine(maps);
  }
}

}  // namespace refitlab
