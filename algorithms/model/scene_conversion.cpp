// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/scene_conversion.hpp"

#include <cmath>
#include <set>

namespace refitlab {

Eigen::Matrix4d to_eigen(const aiMatrix4x4& m) {
  Eigen::Matrix4d out;
  out << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return out;
}
Eigen::Vector3d to_eigen(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Eigen::Quaterniond to_eigen(const aiQuaternion& q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z); }

namespace {

constexpr double usual_ticks_per_second = 25;  // where a file does not say

bool is_usable(const Eigen::Vector3d& v) { return v.allFinite(); }
bool is_usable(const Eigen::Quaterniond& q) { return q.coeffs().allFinite() && q.norm() > 1e-6; }
Eigen::Vector3d in_standard_form(const Eigen::Vector3d& v) { return v; }
Eigen::Quaterniond in_standard_form(const Eigen::Quaterniond& q) { return q.normalized(); }

// The keys of one kind, or the node's own value where the channel has none. thing: clip and joint, for errors.
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

}  // namespace

NodeTree::NodeTree(const aiScene& scene, const std::string& file) : file_(file) { add(*scene.mRootNode, -1); }

void NodeTree::add(const aiNode& node, int parent) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back({node.mName.C_Str(), parent, to_eigen(node.mTransformation)});
  sources_.push_back(&node);
  if (!nodes_.back().local.allFinite())
    throw ModelError(file_, "node '" + nodes_.back().name + "'", "its transform is not finite");
  for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], index);
}

int NodeTree::find(const std::string& name) const {
  int found = -1;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].name != name) continue;
    if (found >= 0) throw ModelError(file_, "node '" + name + "'", "two nodes have this name");
    found = static_cast<int>(i);
  }
  return found;
}

std::vector<Animation> convert_animations(const aiScene& scene, const NodeTree& tree, const std::string& file) {
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

}  // namespace refitlab
