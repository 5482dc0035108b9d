// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/model_of_scene.hpp"

#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "algorithms/model/load.hpp"
#include "algorithms/model/mesh_binding.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using Weights = std::vector<std::pair<int, double>>;  // joint, weight

std::string name_of(const aiMesh& mesh) { return "mesh '" + std::string(mesh.mName.C_Str()) + "'"; }

// What later steps take for granted, assimp's own triangulation among them.
void check_mesh(const aiMesh& mesh, const std::string& file) {
  const std::string thing = name_of(mesh);
  if (mesh.mNumVertices == 0 || mesh.mNumFaces == 0 || !mesh.mVertices) throw ModelError(file, thing, "is empty");
  for (unsigned v = 0; v < mesh.mNumVertices; ++v)
    if (!to_eigen(mesh.mVertices[v]).allFinite())
      throw ModelError(file, thing, "the position of vertex " + std::to_string(v) + " is not finite");
  for (unsigned f = 0; f < mesh.mNumFaces; ++f)
    for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i)
      if (mesh.mFaces[f].mIndices[i] >= mesh.mNumVertices)
        throw ModelError(file, thing, "face " + std::to_string(f) + " names a vertex out of range");
  for (unsigned b = 0; b < mesh.mNumBones; ++b)
    for (unsigned w = 0; w < mesh.mBones[b]->mNumWeights; ++w) {
      const aiVertexWeight& weight = mesh.mBones[b]->mWeights[w];
      const std::string at = thing + ", vertex " + std::to_string(weight.mVertexId);
      if (weight.mVertexId >= mesh.mNumVertices) throw ModelError(file, at, "a bone names a vertex out of range");
      if (!std::isfinite(weight.mWeight)) throw ModelError(file, at, "a weight is not a finite number");
      if (weight.mWeight < 0) throw ModelError(file, at, "weight " + std::to_string(weight.mWeight) + " is negative");
    }
}

std::vector<Weights> weights_by_vertex(const BoundMesh& bound) {
  std::vector<Weights> out(bound.mesh->mNumVertices);
  if (!bound.mesh->HasBones()) out.assign(out.size(), {{bound.joints[0], 1.0}});
  for (unsigned b = 0; b < bound.mesh->mNumBones; ++b)
    for (unsigned w = 0; w < bound.mesh->mBones[b]->mNumWeights; ++w) {
      const aiVertexWeight& weight = bound.mesh->mBones[b]->mWeights[w];
      if (weight.mWeight > 0) out[weight.mVertexId].emplace_back(bound.joints[b], weight.mWeight);
    }
  return out;
}

// Gathers the triangles of all meshes, a vertex for each position and weights.
class Skin {
 public:
  explicit Skin(Model& model) : model_(model) {}

  void add(const BoundMesh& bound) {
    const std::vector<Weights> weights = weights_by_vertex(bound);
    const bool mirrored = bound.placement.determinant() < 0;
    for (unsigned f = 0; f < bound.mesh->mNumFaces; ++f) {
      const aiFace& face = bound.mesh->mFaces[f];
      if (face.mNumIndices != 3) continue;
      Triangle t;
      for (int k = 0; k < 3; ++k) t[k] = vertex(bound, face.mIndices[k], weights[face.mIndices[k]]);
      if (mirrored) std::swap(t[1], t[2]);
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) model_.triangles.push_back(t);
    }
  }

 private:
  int vertex(const BoundMesh& bound, unsigned index, const Weights& weights) {
    double sum = 0;
    for (const auto& [joint, weight] : weights) sum += weight;
    if (!(sum >= least_weight_sum && sum <= greatest_weight_sum)) {
      const std::string reason = sum == 0 ? "no weight" : "its weights sum to " + std::to_string(sum) + ", not 1";
      throw ModelError(model_.name, name_of(*bound.mesh) + ", vertex " + std::to_string(index), reason);
    }
    const Point3 rest = (bound.placement * to_eigen(bound.mesh->mVertices[index]).homogeneous()).head<3>();
    const Key key{{rest[0], rest[1], rest[2]}, quantize_weights(weights)};
    const auto [found, is_new] = known_.try_emplace(key, static_cast<int>(model_.vertices.size()));
    if (is_new) {
      model_.vertices.push_back(rest);
      auto& influences = model_.influences.emplace_back();
      for (const auto& [joint, weight] : key.second) influences.push_back({joint, weight});
    }
    return found->second;
  }

  using Key = std::pair<std::array<double, 3>, Weights>;
  Model& model_;
  std::map<Key, int> known_;
};

// Moves the constant factor of the skin matrices (see skeleton_motion.hpp) into the reference pose.
void factor_out(const Eigen::Matrix4d& factor, BoundSkeleton& skeleton, std::vector<BoundMesh>& meshes) {
  const Eigen::Matrix4d back = factor.inverse();
  for (BoundJoint& joint : skeleton.joints) joint.offset = joint.offset * back;
  for (BoundMesh& mesh : meshes) mesh.placement = factor * mesh.placement;
}

std::vector<Joint> rest_joints(const BoundSkeleton& skeleton) {
  std::vector<Joint> joints;
  for (const BoundJoint& j : skeleton.joints) joints.push_back({j.name, j.parent, j.offset.inverse().topRightCorner<3, 1>()});
  return joints;
}

void check_node(const aiNode& node, const aiScene& scene, const std::string& file) {
  for (unsigned m = 0; m < node.mNumMeshes; ++m)
    if (node.mMeshes[m] >= scene.mNumMeshes)
      throw ModelError(file, "node '" + std::string(node.mName.C_Str()) + "'", "names a mesh out of range");
  for (unsigned c = 0; c < node.mNumChildren; ++c) check_node(*node.mChildren[c], scene, file);
}

}  // namespace

void check_scene(const aiScene& scene, const std::string& file) {
  if (!scene.mRootNode || scene.mNumMeshes == 0) throw ModelError(file, "file", "has no mesh");
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) check_mesh(*scene.mMeshes[m], file);
  check_node(*scene.mRootNode, scene, file);
}

Model model_of_scene(const aiScene& scene, const std::string& file) {
  const DefaultFloatEnvironment environment;
  const NodeTree tree(scene, file);
  BoundScene bound = bind_meshes(scene, tree, file);
  const std::vector<Animation> motions = convert_animations(scene, tree, file);

  auto skeleton = std::make_shared<BoundSkeleton>(BoundSkeleton{file, tree.nodes(), std::move(bound.joints)});
  const Animation first = motions.empty() ? Animation{} : motions.front();
  factor_out(common_factor(*skeleton, first, 0), *skeleton, bound.meshes);

  Model model;
  model.name = file;
  model.joints = rest_joints(*skeleton);
  model.rigidity_defect = pose(*skeleton, first, 0).rigidity_defect;
  Skin skin(model);
  for (const BoundMesh& mesh : bound.meshes) skin.add(mesh);
  for (const Animation& motion : motions) {
    for (const double time : key_times(motion, max_checked_times))
      model.rigidity_defect = std::max(model.rigidity_defect, pose(*skeleton, motion, time).rigidity_defect);
    model.clips.push_back(
        {motion.name, motion.duration, [skeleton, motion](double time) { return pose(*skeleton, motion, time).pose; }, motion});
  }
  model.skeleton = *skeleton;
  validate(model);
  return model;
}

}  // namespace refitlab
