// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/fuzz/scene_of_bytes.hpp"

#include <vector>

#include "proptests/fuzz/byte_stream.hpp"

namespace proptests::fuzz {
namespace {

const char* const names[] = {"a", "b", "c", "d", "e", "f", "g", "h"};

// Returns a number that is mostly a small multiple of 1/8, and sometimes any float, also no number or infinity.
float number(ByteStream& in) {
  return in.one_in(32) ? in.any_float() : static_cast<float>(static_cast<int>(in.below(65)) - 32) / 8;
}

// Returns null for no elements, which assimp would not free.
template <class T>
T* array(unsigned count) {
  return count > 0 ? new T[count] : nullptr;
}

aiVector3D vector(ByteStream& in) {
  const float x = number(in), y = number(in), z = number(in);
  return {x, y, z};
}

aiQuaternion rotation(ByteStream& in) {
  const float w = number(in), x = number(in), y = number(in), z = number(in);
  aiQuaternion q(w, x, y, z);
  if (!in.one_in(16)) q.Normalize();
  return q;
}

// Returns a matrix that is mostly rigid.
aiMatrix4x4 matrix(ByteStream& in) {
  aiMatrix4x4 out;
  if (in.one_in(8))
    for (unsigned row = 0; row < 4; ++row)
      for (unsigned column = 0; column < 4; ++column) out[row][column] = number(in);
  else if (in.one_in(2)) out = aiMatrix4x4(aiVector3D(in.one_in(8) ? number(in) : 1), rotation(in), vector(in));
  return out;
}

aiNode* node(ByteStream& in, unsigned index, unsigned meshes) {
  auto* out = new aiNode(in.one_in(16) ? names[in.below(8)] : names[index]);
  out->mTransformation = matrix(in);
  out->mNumMeshes = in.below(3);
  if (index == 0 && out->mNumMeshes == 0) out->mNumMeshes = 1;
  out->mMeshes = array<unsigned>(out->mNumMeshes);
  for (unsigned m = 0; m < out->mNumMeshes; ++m) out->mMeshes[m] = in.one_in(16) ? in.byte() : in.below(meshes);
  return out;
}

// Makes a tree in which each node comes after its parent.
aiNode* tree(ByteStream& in, unsigned meshes) {
  std::vector<aiNode*> nodes = {node(in, 0, meshes)};
  const unsigned count = 1 + in.below(8);
  std::vector<std::vector<aiNode*>> children(count);
  for (unsigned n = 1; n < count; ++n) {
    const unsigned parent = in.below(n);
    nodes.push_back(node(in, n, meshes));
    nodes[n]->mParent = nodes[parent];
    children[parent].push_back(nodes[n]);
  }
  for (unsigned n = 0; n < count; ++n) {
    nodes[n]->mNumChildren = static_cast<unsigned>(children[n].size());
    nodes[n]->mChildren = array<aiNode*>(children[n].size());
    std::copy(children[n].begin(), children[n].end(), nodes[n]->mChildren);
  }
  return nodes[0];
}

aiBone* bone(ByteStream& in, unsigned vertices) {
  auto* out = new aiBone;
  out->mName = names[in.below(8)];
  out->mOffsetMatrix = matrix(in);
  out->mNumWeights = in.one_in(8) ? in.below(16) : vertices;
  out->mWeights = array<aiVertexWeight>(out->mNumWeights);
  const bool whole = in.one_in(2);
  for (unsigned w = 0; w < out->mNumWeights; ++w) {
    const unsigned vertex = in.one_in(32) ? in.byte() : vertices > 0 ? w % vertices : w;
    out->mWeights[w] = {vertex, in.one_in(32) ? number(in) : whole ? 1.0f : 0.25f * static_cast<float>(in.below(5))};
  }
  return out;
}

aiMesh* mesh(ByteStream& in) {
  auto* out = new aiMesh;
  out->mName = "mesh";
  out->mNumVertices = in.below(13);
  out->mVertices = array<aiVector3D>(out->mNumVertices);
  for (unsigned v = 0; v < out->mNumVertices; ++v) out->mVertices[v] = vector(in);
  out->mNumFaces = in.below(17);
  out->mFaces = array<aiFace>(out->mNumFaces);
  for (unsigned f = 0; f < out->mNumFaces; ++f) {
    aiFace& face = out->mFaces[f];
    face.mNumIndices = in.one_in(8) ? 1 + in.below(4) : 3;
    face.mIndices = array<unsigned>(face.mNumIndices);
    for (unsigned i = 0; i < face.mNumIndices; ++i)
      face.mIndices[i] = in.one_in(32) || out->mNumVertices == 0 ? in.byte() : in.below(out->mNumVertices);
  }
  out->mNumBones = in.below(5);
  out->mBones = array<aiBone*>(out->mNumBones);
  for (unsigned b = 0; b < out->mNumBones; ++b) out->mBones[b] = bone(in, out->mNumVertices);
  return out;
}

template <class Keys, class Value>
void keys(ByteStream& in, unsigned& count, Keys*& list, const Value& value) {
  count = in.below(4);
  list = array<Keys>(count);
  double time = 0;
  for (unsigned k = 0; k < count; ++k) {
    time += in.one_in(16) ? static_cast<double>(number(in)) : in.below(8);
    list[k].mTime = time;
    list[k].mValue = value(in);
  }
}

aiAnimation* clip(ByteStream& in) {
  auto* out = new aiAnimation;
  if (in.one_in(2)) out->mName = "clip";
  out->mDuration = in.one_in(16) ? static_cast<double>(number(in)) : in.below(32);
  out->mTicksPerSecond = in.one_in(8) ? static_cast<double>(number(in)) : in.below(4);
  out->mNumChannels = in.below(5);
  out->mChannels = array<aiNodeAnim*>(out->mNumChannels);
  for (unsigned c = 0; c < out->mNumChannels; ++c) {
    auto* channel = out->mChannels[c] = new aiNodeAnim;
    channel->mNodeName = names[in.below(8)];
    keys(in, channel->mNumPositionKeys, channel->mPositionKeys, vector);
    keys(in, channel->mNumRotationKeys, channel->mRotationKeys, rotation);
    if (in.one_in(8)) keys(in, channel->mNumScalingKeys, channel->mScalingKeys, vector);
  }
  return out;
}

}  // namespace

std::unique_ptr<aiScene> scene_of_bytes(const std::string& bytes) {
  ByteStream in(bytes);
  auto scene = std::make_unique<aiScene>();
  scene->mNumMeshes = 1 + in.below(3);
  scene->mMeshes = array<aiMesh*>(scene->mNumMeshes);
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) scene->mMeshes[m] = mesh(in);
  scene->mRootNode = tree(in, scene->mNumMeshes);
  scene->mNumAnimations = in.below(3);
  scene->mAnimations = array<aiAnimation*>(scene->mNumAnimations);
  for (unsigned a = 0; a < scene->mNumAnimations; ++a) scene->mAnimations[a] = clip(in);
  return scene;
}

}  // namespace proptests::fuzz
