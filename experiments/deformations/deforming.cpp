// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/deforming.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/balls/box.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

constexpr int target_count = 3;

Point3 factors(Scales scales, std::size_t joint) {
  const auto j = static_cast<double>(joint);
  const double a = 0.9 + 0.35 * std::sin(j), b = 0.95 + 0.25 * std::cos(1.7 * j);
  switch (scales) {
    case Scales::uniform: return {a, a, a};
    case Scales::axes: return {a, b, 1.0};
    default: return {1, 1, 1};
  }
}

}  // namespace

AffinePose scaled(const SkinnedMesh& mesh, const Pose& pose, Scales scales) {
  AffinePose out;
  for (std::size_t j = 0; j < pose.size(); ++j) {
    const Point3 factor = factors(scales, j), &origin = mesh.joints[j].origin;
    AffineMap<double> map;
    for (int i = 0; i < 3; ++i)
      map.columns[static_cast<std::size_t>(i)] = rotate<double>(pose[j].rotation, Point3::Unit(i)) * factor[i];
    map.offset = apply(pose[j], origin) - turned_by(map, origin);
    out.push_back(map);
  }
  return out;
}

void add_targets(SkinnedMesh& mesh) {
  const auto box = box_around<double>(mesh.vertices);
  const double size = box.edges().maxCoeff();
  const Point3 middle = box.center();
  mesh.targets = {target_count, std::vector<std::vector<Displacement<double>>>(mesh.vertices.size())};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point3 x = (mesh.vertices[v] - middle) / size;
    auto& by = mesh.targets.of_vertex[v];
    if (x.norm() < 0.15) by.push_back({0, Point3(x * (0.5 * size))});
    by.push_back({1, Point3(x[1] * x[1] * 0.3 * size, 0, 0)});
    by.push_back({2, Point3(std::sin(60 * x[1]), 0, std::cos(50 * x[0])) * (0.01 * size)});
  }
}

DeformingCharacters::DeformingCharacters(const Model& model) {
  Model morphed = model;
  add_targets(morphed);
  for (const Joints joints : {Joints::rigid, Joints::affine}) {
    for (const Model& made : {model, morphed})
      baked_[joints == Joints::affine ? 1 : 0].push_back(bake_animated(made, {}, all_pieces, joints));
  }
}

std::vector<DeformedPose> deformed_poses(const AnimatedCharacter& c, const DeformationKind& kind,
                                         std::span<const double> shares) {
  std::vector<DeformedPose> out;
  for (const Clip& clip : c.clips)
    for (const double share : shares) {
      const Pose pose = clip.sample(share * clip.duration);
      std::vector<double> weights;
      if (kind.has_morphs) weights = {0.8, std::sin(static_cast<double>(out.size() + 1)), 0.5};
      if (kind.scales == Scales::none) out.push_back({pose, {}, {}, std::move(weights)});
      else out.push_back(deformed_pose(c.mesh, scaled(c.mesh, pose, kind.scales), std::move(weights)));
    }
  return out;
}

bool deforms_itself(const Model& model) { return !model.morphs.empty() || joints_of(model) == Joints::affine; }

std::vector<DeformedPose> own_poses(const Model& model, std::span<const double> shares) {
  std::vector<DeformedPose> out;
  for (const Clip& clip : model.clips)
    for (const double share : shares) {
      const double time = share * clip.duration;
      out.push_back(
          deformed_pose(model, affine_pose(model.skeleton, clip.animation, time), morph_weights(model, clip.animation, time)));
    }
  if (out.empty()) {
    const auto count = static_cast<std::size_t>(morph_targets(model).count);
    out.push_back(deformed_pose(model, affine_pose(model.skeleton, {}, 0), std::vector<double>(count, 0.5)));
  }
  return out;
}

std::vector<double> even_shares(int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back((i + 0.5) / count);
  return out;
}

}  // namespace refitlab
