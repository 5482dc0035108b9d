// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/model.hpp"

#include <algorithm>
#include <utility>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr int moments_looked_at = 16;

// Returns the part of a vertex in a list by vertex in increasing order.
template <class T>
std::span<const T> part_of_vertex(std::span<const T> all, int vertex) {
  const auto first = std::lower_bound(all.begin(), all.end(), vertex, [](const T& one, int v) { return one.vertex < v; });
  const auto last = std::upper_bound(first, all.end(), vertex, [](int v, const T& one) { return v < one.vertex; });
  return all.subspan(static_cast<std::size_t>(first - all.begin()), static_cast<std::size_t>(last - first));
}

}  // namespace

Joints joints_of(const Model& model) try {
  for (const Clip& clip : model.clips)
    for (int i = 0; i < moments_looked_at; ++i) clip.sample((i + 0.5) / moments_looked_at * clip.duration);
  if (model.clips.empty() && !model.skeleton.joints.empty()) pose(model.skeleton, {}, 0);
  return Joints::rigid;
} catch (const ModelError&) {
  return Joints::affine;
}

std::span<const LostInfluence> lost_influences(const Model& model, int vertex) {
  return part_of_vertex<LostInfluence>(model.lost_influences, vertex);
}
std::span<const PlacedVertex> placed_vertices(const Model& model, int vertex) {
  return part_of_vertex<PlacedVertex>(model.placed_vertices, vertex);
}

const Point3* displacement_of(const MorphTarget& target, int vertex) {
  const auto& list = target.displacements;
  const auto found = std::lower_bound(list.begin(), list.end(), vertex, [](const auto& d, int v) { return d.first < v; });
  return found != list.end() && found->first == vertex ? &found->second : nullptr;
}

MorphTargets morph_targets(const Model& model) {
  MorphTargets out;
  for (const MorphedMesh& mesh : model.morphs) out.count += static_cast<int>(mesh.targets.size());
  if (out.count == 0) return out;
  out.of_vertex.resize(model.vertices.size());
  int target = 0;
  for (const MorphedMesh& mesh : model.morphs)
    for (const MorphTarget& by : mesh.targets) {
      for (const auto& [vertex, displacement] : by.displacements)
        out.of_vertex[static_cast<std::size_t>(vertex)].push_back({target, displacement});
      ++target;
    }
  return out;
}

SkinnedMesh skinned_mesh(Model model) {
  if (!model.morphs.empty()) model.targets = morph_targets(model);
  return SkinnedMesh(std::move(model));
}

const WeightTrack* weight_track_of(const MorphedMesh& mesh, const Animation& animation) {
  const auto& tracks = animation.weight_tracks;
  const auto found = std::find_if(tracks.begin(), tracks.end(), [&](const WeightTrack& t) { return t.node == mesh.node; });
  return found == tracks.end() ? nullptr : &*found;
}

Eigen::VectorXd weights_at(const MorphedMesh& mesh, const WeightTrack* track, double time, Side side) {
  if (track) return weights_at(*track, time, side);
  return Eigen::Map<const Eigen::VectorXd>(mesh.weights.data(), static_cast<Eigen::Index>(mesh.weights.size()));
}

std::vector<double> morph_weights(const Model& model, const Animation& animation, double time) {
  const DefaultFloatEnvironment environment;
  std::vector<double> out;
  for (const MorphedMesh& mesh : model.morphs) {
    const Eigen::VectorXd weights = weights_at(mesh, weight_track_of(mesh, animation), time);
    out.insert(out.end(), weights.begin(), weights.end());
  }
  return out;
}

}  // namespace refitlab
