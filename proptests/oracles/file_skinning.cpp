// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/file_skinning.hpp"

#include <assimp/postprocess.h>

#include <functional>
#include <map>
#include <set>
#include <stdexcept>

namespace proptests::oracle {
namespace {

// Returns the value between the keys around a time in ticks. blend takes the two keys and the share of the second.
template <class SourceKey, class Blend>
auto value_at(const SourceKey* keys, unsigned count, double ticks, const Blend& blend) {
  for (unsigned k = 0; k + 1 < count; ++k)
    if (ticks >= keys[k].mTime && ticks < keys[k + 1].mTime)
      return blend(keys[k].mValue, keys[k + 1].mValue,
                   static_cast<float>((ticks - keys[k].mTime) / (keys[k + 1].mTime - keys[k].mTime)));
  return ticks < keys[0].mTime ? keys[0].mValue : keys[count - 1].mValue;
}

aiVector3D blend_vectors(const aiVector3D& a, const aiVector3D& b, float t) { return a + t * (b - a); }

aiQuaternion blend_rotations(const aiQuaternion& a, const aiQuaternion& b, float t) {
  aiQuaternion out;
  aiQuaternion::Interpolate(out, a, b, t);
  return out.Normalize();
}

aiMatrix4x4 local_transform(const aiNode& node, const aiAnimation& animation, double ticks) {
  for (unsigned c = 0; c < animation.mNumChannels; ++c) {
    const aiNodeAnim& channel = *animation.mChannels[c];
    if (channel.mNodeName != node.mName) continue;
    aiVector3D scale, position;
    aiQuaternion rotation;
    node.mTransformation.Decompose(scale, rotation, position);
    if (channel.mNumScalingKeys) scale = value_at(channel.mScalingKeys, channel.mNumScalingKeys, ticks, blend_vectors);
    if (channel.mNumRotationKeys) rotation = value_at(channel.mRotationKeys, channel.mNumRotationKeys, ticks, blend_rotations);
    if (channel.mNumPositionKeys) position = value_at(channel.mPositionKeys, channel.mNumPositionKeys, ticks, blend_vectors);
    // The constructor from these three is not used: it scales the rows of the rotation.
    aiMatrix4x4 move, stretch;
    return aiMatrix4x4::Translation(position, move) * aiMatrix4x4(rotation.GetMatrix()) * aiMatrix4x4::Scaling(scale, stretch);
  }
  return node.mTransformation;
}

}  // namespace

FileSkinning::FileSkinning(const std::string& path) : scene_(importer_.ReadFile(path, aiProcess_Triangulate)) {
  if (!scene_) throw std::runtime_error(path + ": " + importer_.GetErrorString());
}

std::vector<std::array<aiVector3D, 3>> FileSkinning::posed_triangles(unsigned clip, double time) const {
  const aiAnimation& animation = *scene_->mAnimations[clip];
  const double ticks = time * (animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 25);
  const auto global = [&](const aiNode* node) {
    aiMatrix4x4 out;
    for (; node; node = node->mParent) out = local_transform(*node, animation, ticks) * out;
    return out;
  };

  std::vector<std::array<aiVector3D, 3>> triangles;
  std::set<const aiMesh*> done;
  const std::function<void(const aiNode*)> visit = [&](const aiNode* node) {
    for (unsigned m = 0; m < node->mNumMeshes; ++m) {
      const aiMesh* mesh = scene_->mMeshes[node->mMeshes[m]];
      if (mesh->HasBones() && !done.insert(mesh).second) continue;
      std::vector<std::map<std::string, float>> weights(mesh->mNumVertices);
      std::vector<aiVector3D> posed(mesh->mNumVertices);
      for (unsigned b = 0; b < mesh->mNumBones; ++b) {
        const aiBone& bone = *mesh->mBones[b];
        const aiMatrix4x4 matrix = global(scene_->mRootNode->FindNode(bone.mName)) * bone.mOffsetMatrix;
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
          const auto [v, weight] = bone.mWeights[w];
          posed[v] += weight * (matrix * mesh->mVertices[v]);
          if (weight != 0) weights[v][bone.mName.C_Str()] += weight;
        }
      }
      for (unsigned v = 0; v < mesh->mNumVertices; ++v) {
        float sum = 0;
        for (const auto& [bone, weight] : weights[v]) sum += weight;
        posed[v] = mesh->HasBones() ? posed[v] / sum : global(node) * mesh->mVertices[v];
      }
      const auto agree = [&](unsigned a, unsigned b) {
        return mesh->mVertices[a] == mesh->mVertices[b] && weights[a] == weights[b];
      };
      for (unsigned f = 0; f < mesh->mNumFaces; ++f) {
        if (mesh->mFaces[f].mNumIndices != 3) continue;
        const unsigned* i = mesh->mFaces[f].mIndices;
        if (!agree(i[0], i[1]) && !agree(i[1], i[2]) && !agree(i[2], i[0]))
          triangles.push_back({posed[i[0]], posed[i[1]], posed[i[2]]});
      }
    }
    for (unsigned c = 0; c < node->mNumChildren; ++c) visit(node->mChildren[c]);
  };
  visit(scene_->mRootNode);
  return triangles;
}

}  // namespace proptests::oracle
