// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/model_of_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "algorithms/model/load.hpp"
#include "algorithms/model/mesh_binding.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using Weights = std::vector<std::pair<int, double>>;  // joint, weight

// A Skin gathers the triangles of all primitives. It has one vertex for each position with its weights and displacements.
class Skin {
 public:
  Skin(const Scene& scene, Morphs morphs, Model& model) : scene_(scene), morphs_(morphs), model_(model) {}

  void add(const BoundPrimitive& bound) {
    const ShownMesh& use = scene_.shown[bound.shown];
    const ScenePrimitive& primitive = scene_.meshes[use.mesh].primitives[bound.primitive];
    const int morphed = morphs_ == Morphs::moving && !primitive.targets.empty() ? morphed_mesh(use) : -1;
    SourcePrimitive source{
        scene_.nodes[use.node].source, use.mesh, bound.primitive, use.skin, std::vector<int>(primitive.positions.size(), -1), {}};
    const bool mirrored = bound.placement.determinant() < 0;
    farthest_sum_ = 0, off_sums_ = 0;
    int left_out = 0;
    std::vector<Known*> known_of(primitive.positions.size());
    for (const Triangle& triangle : primitive.triangles) {
      for (const int v : triangle)
        if (!known_of[v]) known_of[v] = &known(bound, primitive, v, morphed);
      const Known *a = known_of[triangle[0]], *b = known_of[triangle[1]], *c = known_of[triangle[2]];
      const bool kept = a != b && b != c && c != a;
      source.triangles.push_back(kept ? static_cast<int>(model_.triangles.size()) : -1);
      left_out += !kept;
      if (!kept) continue;
      Triangle t;
      for (int k = 0; k < 3; ++k) t[k] = source.vertices[triangle[k]] = vertex(*known_of[triangle[k]]);
      if (mirrored) std::swap(t[1], t[2]);
      model_.triangles.push_back(t);
    }
    if (off_sums_ > 0)
      model_.notes.push_back(primitive.label + ": the weights of " + std::to_string(off_sums_) +
                             " vertices do not sum to 1 but are off by up to " + std::to_string(farthest_sum_) +
                             "; they are divided by their sums");
    if (left_out > 0)
      model_.notes.push_back(primitive.label + ": " + std::to_string(left_out) + " of " +
                             std::to_string(primitive.triangles.size()) +
                             " triangles have two equal vertices; they are left out, and so are vertices of no other triangle");
    if (!bound.placement.isIdentity(0)) place(bound.placement, source.vertices);
    model_.sources.push_back(std::move(source));
  }

  // Is called after all primitives.
  void finish() {
    auto& placed = model_.placed_vertices;
    const auto key = [](const PlacedVertex& v) { return std::pair(v.vertex, v.placement); };
    std::sort(placed.begin(), placed.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    placed.erase(std::unique(placed.begin(), placed.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
                 placed.end());
  }

 private:
  void place(const Eigen::Matrix4d& placement, const std::vector<int>& vertices) {
    auto& placements = model_.placements;
    const auto found = std::find(placements.begin(), placements.end(), placement);
    const int index = static_cast<int>(found - placements.begin());
    if (found == placements.end()) placements.push_back(placement);
    for (const int v : vertices)
      if (v >= 0) model_.placed_vertices.push_back({v, index});
  }

  // Returns the index of the node's mesh in model.morphs, and makes room for its targets.
  int morphed_mesh(const ShownMesh& use) {
    auto& meshes = model_.morphs;
    const auto found = std::find_if(meshes.begin(), meshes.end(), [&](const MorphedMesh& m) { return m.node == use.node; });
    if (found != meshes.end()) return static_cast<int>(found - meshes.begin());
    meshes.push_back({use.node, use.weights, std::vector<MorphTarget>(use.weights.size())});
    return static_cast<int>(meshes.size()) - 1;
  }

  // Returns the weights in the order of the skin's joints, so that their sum does not depend on the format.
  static Weights weights_of(const BoundPrimitive& bound, const ScenePrimitive& primitive, int index, bool skinned) {
    if (!skinned) return {{bound.joints[0], 1.0}};
    Weights out = primitive.weights[index];
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& weight : out) weight.first = bound.joints[weight.first];
    return out;
  }

  // Returns the position in the primitive's frame, with the displacements of weights that do not move.
  Eigen::Vector3d position_of(const ShownMesh& use, const ScenePrimitive& primitive, int index) const {
    Eigen::Vector3d out = primitive.positions[index];
    for (std::size_t t = 0; morphs_ == Morphs::constant && t < primitive.targets.size(); ++t)
      if (use.weights[t] != 0) out += use.weights[t] * primitive.targets[t][index];
    return out;
  }

  // Returns the displacements in the reference pose, target by target, or nothing if all are zero.
  static std::vector<double> displacements_of(const BoundPrimitive& bound, const ScenePrimitive& primitive, int index) {
    std::vector<double> out;
    bool any = false;
    for (const auto& target : primitive.targets) {
      const Eigen::Vector3d moved = bound.placement.topLeftCorner<3, 3>() * target[index];
      any = any || !moved.isZero(0);
      out.insert(out.end(), {moved[0], moved[1], moved[2]});
    }
    return any ? out : std::vector<double>{};
  }

  // What tells vertices apart is their place, weights, node's mesh in model.morphs and displacements.
  using Key = std::tuple<std::array<double, 3>, Weights, int, std::vector<double>>;
  // A Known is a key with the model's vertex, which is -1 until a triangle has it.
  using Known = std::pair<const Key, int>;

  Known& known(const BoundPrimitive& bound, const ScenePrimitive& primitive, int index, int morphed) {
    const ShownMesh& use = scene_.shown[bound.shown];
    const Weights weights = weights_of(bound, primitive, index, use.skin >= 0);
    double sum = 0;
    for (const auto& [joint, weight] : weights) sum += weight;
    if (!(sum >= least_weight_sum && sum <= greatest_weight_sum)) {
      const std::string reason = sum == 0 ? "no weight" : "its weights sum to " + std::to_string(sum) + ", not 1";
      throw ModelError(model_.name, primitive.label + ", vertex " + std::to_string(index), reason);
    }
    if (std::abs(sum - 1) > usual_sum_error) ++off_sums_;
    farthest_sum_ = std::max(farthest_sum_, std::abs(sum - 1));
    const Point3 rest = (bound.placement * position_of(use, primitive, index).homogeneous()).head<3>();
    const std::vector<double> moved = morphed < 0 ? std::vector<double>{} : displacements_of(bound, primitive, index);
    // The weights are the file's own: vertices that only the rounding of weights makes equal stay apart, and a triangle of them
    // has three vertices.
    return *known_.try_emplace({{rest[0], rest[1], rest[2]}, weights, moved.empty() ? -1 : morphed, moved}, -1).first;
  }

  int vertex(Known& known) {
    auto& [key, vertex] = known;
    if (vertex >= 0) return vertex;
    vertex = static_cast<int>(model_.vertices.size());
    const auto& [rest, weights, morphed, moved] = key;
    for (std::size_t t = 0; t < moved.size() / 3; ++t)
      if (const Point3 by(moved[3 * t], moved[3 * t + 1], moved[3 * t + 2]); !by.isZero(0))
        model_.morphs[morphed].targets[t].displacements.emplace_back(vertex, by);
    model_.vertices.emplace_back(rest[0], rest[1], rest[2]);
    auto& influences = model_.influences.emplace_back();
    Weights lost;
    for (const auto& [joint, weight] : quantize_weights(weights, &lost)) influences.push_back({joint, weight});
    for (const auto& [joint, share] : lost) model_.lost_influences.push_back({vertex, joint, share});
    return vertex;
  }

  static constexpr double usual_sum_error = 1e-3;  // of weights with few digits

  const Scene& scene_;
  Morphs morphs_;
  Model& model_;
  std::map<Key, int> known_;
  // In the current primitive, so many vertices have weights that do not sum to 1, and the sum is off by so much at most.
  long off_sums_ = 0;
  double farthest_sum_ = 0;
};

void note_what_has_no_triangle(const Scene& scene, Model& model) {
  for (const SceneMesh& mesh : scene.meshes)
    for (const ScenePrimitive& primitive : mesh.primitives)
      if (primitive.triangles.empty()) model.notes.push_back(primitive.label + ": has no triangles, and is left out");
}

void add_repeated_sources(const Scene& scene, const BoundScene& bound, Model& model) {
  const std::size_t own = model.sources.size();
  for (const RepeatedMesh& repeated : bound.repeated)
    for (std::size_t i = 0; i < own; ++i) {
      const ShownMesh& first = scene.shown[repeated.first];
      if (model.sources[i].node != scene.nodes[first.node].source || model.sources[i].mesh != first.mesh) continue;
      SourcePrimitive again = model.sources[i];
      again.node = scene.nodes[scene.shown[repeated.shown].node].source;
      model.sources.push_back(std::move(again));
    }
}

// Throws ModelError for a clip whose morph weights ever differ from those of the node.
void check_weights_stay(const Scene& scene) {
  for (const ShownMesh& use : scene.shown)
    for (const Animation& motion : scene.animations)
      for (const WeightTrack& track : motion.weight_tracks) {
        if (track.node != use.node) continue;
        const auto rest = Eigen::Map<const Eigen::VectorXd>(use.weights.data(), static_cast<Eigen::Index>(use.weights.size()));
        bool stay = true;
        for (const auto& key : track.weights.keys) stay = stay && key.value == rest;
        for (const auto& tangents : track.weights.tangents) stay = stay && tangents.into.isZero(0) && tangents.out.isZero(0);
        if (!stay)
          throw ModelError(scene.file, "clip '" + motion.name + "', node '" + scene.nodes[use.node].name + "'",
                           "moves the weights of morph targets, which this program does not bound");
      }
}

// Moves the constant factor of the skin matrices (see skeleton_motion.hpp) into the reference pose.
void factor_out(const Eigen::Matrix4d& factor, BoundSkeleton& skeleton, std::vector<BoundPrimitive>& primitives) {
  const Eigen::Matrix4d back = factor.inverse();
  for (BoundJoint& joint : skeleton.joints) joint.offset = joint.offset * back;
  for (BoundPrimitive& bound : primitives) bound.placement = factor * bound.placement;
}

std::vector<Joint> rest_joints(const BoundSkeleton& skeleton) {
  std::vector<Joint> joints;
  for (const BoundJoint& j : skeleton.joints) joints.push_back({j.name, j.parent, j.offset.inverse().topRightCorner<3, 1>()});
  return joints;
}

// Returns the greatest defect over the reference pose and all clips, at the times that are checked on loading.
double greatest_defect(const BoundSkeleton& skeleton, const std::vector<Animation>& motions) {
  double out = rigidity_defect(skin_matrices(skeleton, motions.empty() ? Animation{} : motions.front(), 0));
  for (const Animation& motion : motions)
    for (const double time : key_times(motion, max_checked_times))
      out = std::max(out, rigidity_defect(skin_matrices(skeleton, motion, time)));
  return out;
}

// Returns the same, but throws ModelError if a pose is not rigid.
double checked_defect(const BoundSkeleton& skeleton, const std::vector<Animation>& motions) {
  double out = pose(skeleton, motions.empty() ? Animation{} : motions.front(), 0).rigidity_defect;
  for (const Animation& motion : motions)
    for (const double time : key_times(motion, max_checked_times))
      out = std::max(out, pose(skeleton, motion, time).rigidity_defect);
  return out;
}

}  // namespace

Model model_of_scene(const Scene& scene, const LoadOptions& options) {
  const DefaultFloatEnvironment environment;
  if (options.morphs == Morphs::constant) check_weights_stay(scene);
  const BoundScene bound = bind_meshes(scene);
  Model model;
  model.name = scene.file;
  model.skeleton = {scene.file, scene.nodes, bound.joints};
  std::vector<BoundPrimitive> primitives = bound.primitives;
  const Eigen::Matrix4d factor =
      common_factor(model.skeleton, scene.animations.empty() ? Animation{} : scene.animations.front(), 0);
  factor_out(factor, model.skeleton, primitives);
  if (options.joints == Joints::rigid) {
    model.rigidity_defect = checked_defect(model.skeleton, scene.animations);
  } else {
    model.rigidity_defect = greatest_defect(model.skeleton, scene.animations);
    if (!(model.rigidity_defect <= rigidity_tolerance)) {
      model.skeleton.joints = bound.joints;
      primitives = bound.primitives;
      model.rigidity_defect = greatest_defect(model.skeleton, scene.animations);
    }
  }

  model.joints = rest_joints(model.skeleton);
  Skin skin(scene, options.morphs, model);
  for (const BoundPrimitive& primitive : primitives) skin.add(primitive);
  skin.finish();
  add_repeated_sources(scene, bound, model);
  model.notes.insert(model.notes.begin(), scene.notes.begin(), scene.notes.end());
  note_what_has_no_triangle(scene, model);
  const auto skeleton = std::make_shared<const BoundSkeleton>(model.skeleton);
  for (Animation motion : scene.animations) {
    if (model.morphs.empty()) motion.weight_tracks.clear();
    model.clips.push_back(
        {motion.name, motion.duration, [skeleton, motion](double time) { return pose(*skeleton, motion, time).pose; }, motion});
  }
  validate(model);
  return model;
}

}  // namespace refitlab
