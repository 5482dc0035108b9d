// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/assimp_scene.hpp"

#include <assimp/postprocess.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <set>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Converts the file's numbers exactly.
Eigen::Matrix4d to_eigen(const aiMatrix4x4& m) {
  Eigen::Matrix4d out;
  out << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return out;
}
Eigen::Vector3d to_eigen(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Eigen::Quaterniond to_eigen(const aiQuaternion& q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z); }

constexpr double usual_ticks_per_second = 25;  // where a file does not say

bool is_usable(const Eigen::Vector3d& v) { return v.allFinite(); }
bool is_usable(const Eigen::Quaterniond& q) { return q.coeffs().allFinite() && q.norm() > 1e-6; }
Eigen::Vector3d in_standard_form(const Eigen::Vector3d& v) { return v; }
Eigen::Quaterniond in_standard_form(const Eigen::Quaterniond& q) { return q.normalized(); }

// Returns the keys of one kind, or the node's own value if the channel has none. thing names the clip and the joint for errors.
template <class Value, class SourceKey, class SourceValue>
std::vector<Key<Value>> convert_keys(const SourceKey* keys, unsigned count, double ticks_per_second, const SourceValue& otherwise,
                                     const std::string& file, const std::string& thing) {
  if (count == 0) return {{0, to_eigen(otherwise)}};
  std::vector<Key<Value>> out;
  for (unsigned k = 0; k < count; ++k) {
    const double time = keys[k].mTime / ticks_per_second;
    const std::string at = thing + ", key " + std::to_string(k) + " at " + std::to_string(time) + " s";
    const Value value = to_eigen(keys[k].mValue);
    if (!std::isfinite(time) || !is_usable(value)) throw ModelError(file, at, "not finite, or a rotation by a zero quaternion");
    if (!out.empty() && time < out.back().time) throw ModelError(file, at, "keys are not in order of time");
    out.push_back({time, in_standard_form(value)});
  }
  return out;
}

NodeTrack convert_track(const aiNodeAnim& channel, int node, const aiNode& source, double ticks_per_second,
                        const std::string& file, const std::string& thing) {
  aiVector3D scale, position;
  aiQuaternion rotation;
  source.mTransformation.Decompose(scale, rotation, position);
  return {
      node,
      {convert_keys<Eigen::Vector3d>(channel.mPositionKeys, channel.mNumPositionKeys, ticks_per_second, position, file, thing)},
      {convert_keys<Eigen::Quaterniond>(channel.mRotationKeys, channel.mNumRotationKeys, ticks_per_second, rotation, file,
                                        thing)},
      {convert_keys<Eigen::Vector3d>(channel.mScalingKeys, channel.mNumScalingKeys, ticks_per_second, scale, file, thing)}};
}

// NodeTree has the nodes of a scene, depth first and by name, because assimp refers to nodes by name only.
class NodeTree {
 public:
  NodeTree(const aiScene& scene, const std::string& file) : file_(file) { add(*scene.mRootNode, -1); }
  const std::vector<SceneNode>& nodes() const { return nodes_; }
  const aiNode& source(int node) const { return *sources_[node]; }
  // Returns the one node of that name, or -1 if there is none. Throws ModelError if there are two.
  int find(const std::string& name) const {
    int found = -1;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].name != name) continue;
      if (found >= 0) throw ModelError(file_, "node '" + name + "'", "two nodes have this name");
      found = static_cast<int>(i);
    }
    return found;
  }

 private:
  void add(const aiNode& node, int parent) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({node.mName.C_Str(), parent, to_eigen(node.mTransformation), index});
    sources_.push_back(&node);
    if (!nodes_.back().local.allFinite())
      throw ModelError(file_, "node '" + nodes_.back().name + "'", "its transform is not finite");
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], index);
  }
  std::string file_;
  std::vector<SceneNode> nodes_;
  std::vector<const aiNode*> sources_;
};

std::vector<Animation> animations_of(const aiScene& scene, const NodeTree& tree, const std::string& file) {
  std::vector<Animation> animations;
  for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
    const aiAnimation& animation = *scene.mAnimations[a];
    const double rate = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : usual_ticks_per_second;
    Animation motion{animation.mName.C_Str(), animation.mDuration / rate, {}};
    if (motion.name.empty()) motion.name = "clip " + std::to_string(a);
    if (!(motion.duration >= 0 && std::isfinite(motion.duration)))
      throw ModelError(file, "clip '" + motion.name + "'", "its duration is not a time");
    std::set<int> seen;
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
      const aiNodeAnim& channel = *animation.mChannels[c];
      const int node = tree.find(channel.mNodeName.C_Str());
      if (node < 0) continue;
      const std::string thing = "clip '" + motion.name + "', joint '" + channel.mNodeName.C_Str() + "'";
      if (!seen.insert(node).second) throw ModelError(file, thing, "two channels move it");
      motion.tracks.push_back(convert_track(channel, node, tree.source(node), rate, file, thing));
    }
    animations.push_back(std::move(motion));
  }
  return animations;
}

std::string label_of(const aiMesh& mesh) { return "mesh '" + std::string(mesh.mName.C_Str()) + "'"; }

// Checks what later steps, assimp's own triangulation among them, take for granted.
void check_assimp_mesh(const aiMesh& mesh, const std::string& file) {
  const std::string thing = label_of(mesh);
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

void check_node(const aiNode& node, const aiScene& scene, const std::string& file) {
  for (unsigned m = 0; m < node.mNumMeshes; ++m)
    if (node.mMeshes[m] >= scene.mNumMeshes)
      throw ModelError(file, "node '" + std::string(node.mName.C_Str()) + "'", "names a mesh out of range");
  for (unsigned c = 0; c < node.mNumChildren; ++c) check_node(*node.mChildren[c], scene, file);
}

ScenePrimitive primitive_of(const aiMesh& mesh) {
  ScenePrimitive out{label_of(mesh), {}, {}, {}};
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) out.positions.push_back(to_eigen(mesh.mVertices[v]));
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    Triangle& t = out.triangles.emplace_back();
    for (unsigned k = 0; k < 3; ++k) t[k] = static_cast<int>(face.mIndices[k]);
  }
  if (mesh.HasBones()) out.weights.resize(mesh.mNumVertices);
  for (unsigned b = 0; b < mesh.mNumBones; ++b)
    for (unsigned w = 0; w < mesh.mBones[b]->mNumWeights; ++w) {
      const aiVertexWeight& weight = mesh.mBones[b]->mWeights[w];
      if (weight.mWeight > 0) out.weights[weight.mVertexId].emplace_back(static_cast<int>(b), weight.mWeight);
    }
  return out;
}

SceneSkin skin_of(const aiMesh& mesh, const NodeTree& tree, const std::string& file) {
  SceneSkin out;
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    out.joints.push_back(tree.find(bone.mName.C_Str()));
    if (out.joints.back() < 0) throw ModelError(file, "bone '" + std::string(bone.mName.C_Str()) + "'", "no node has this name");
    out.offsets.push_back(to_eigen(bone.mOffsetMatrix));
  }
  return out;
}

// Returns what assimp says of its last failure, shortened, as some of its messages quote the rest of the file.
std::string complaint(const Assimp::Importer& importer) { return std::string(importer.GetErrorString()).substr(0, 200); }

}  // namespace

void check_assimp_scene(const aiScene& source, const std::string& file) {
  if (!source.mRootNode || source.mNumMeshes == 0) throw ModelError(file, "file", "has no mesh");
  for (unsigned m = 0; m < source.mNumMeshes; ++m) check_assimp_mesh(*source.mMeshes[m], file);
  check_node(*source.mRootNode, source, file);
}

Scene convert_scene(const aiScene& source, const std::string& file) {
  const NodeTree tree(source, file);
  Scene out{file, tree.nodes(), {}, {}, {}, {}};
  std::vector<int> skins;  // by mesh
  for (unsigned m = 0; m < source.mNumMeshes; ++m) {
    const aiMesh& mesh = *source.mMeshes[m];
    out.meshes.push_back({{primitive_of(mesh)}});
    if (mesh.mNumAnimMeshes > 0)
      out.notes.push_back(label_of(mesh) + ": has " + std::to_string(mesh.mNumAnimMeshes) +
                          " morph targets, which are read from glTF alone, and are left out");
    skins.push_back(mesh.HasBones() ? static_cast<int>(out.skins.size()) : -1);
    if (mesh.HasBones()) out.skins.push_back(skin_of(mesh, tree, file));
  }
  for (std::size_t n = 0; n < tree.nodes().size(); ++n) {
    const int node = static_cast<int>(n);
    const aiNode& from = tree.source(node);
    for (unsigned m = 0; m < from.mNumMeshes; ++m)
      out.shown.push_back({node, static_cast<int>(from.mMeshes[m]), skins[from.mMeshes[m]]});
  }
  out.animations = animations_of(source, tree, file);
  return out;
}

Scene assimp_scene(const std::string& path) {
  const DefaultFloatEnvironment environment;
  Assimp::Importer importer;
  // The scene is read as the file has it, checked, and then triangulated.
  const aiScene* source = importer.ReadFile(path, 0);
  if (!source) throw ModelError(path, "file", "assimp cannot read it: " + complaint(importer));
  check_assimp_scene(*source, path);
  source = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (!source) throw ModelError(path, "file", "assimp cannot triangulate it: " + complaint(importer));
  return convert_scene(*source, path);
}

}  // namespace refitlab
