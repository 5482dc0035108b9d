// SPDX-License-Identifier: GPL-3.0-or-later
// What assimp read, in double and in the terms of skeleton_motion: nodes and motions.
#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

// The nodes of a scene, depth first, and by name.
class NodeTree {
 public:
  NodeTree(const aiScene& scene, const std::string& file);
  const std::vector<SceneNode>& nodes() const { return nodes_; }
  const aiNode& source(int node) const { return *sources_[node]; }
  // The one node of that name, or -1; throws ModelError where there are two: assimp refers to nodes by name only.
  int find(const std::string& name) const;

 private:
  void add(const aiNode& node, int parent);
  std::string file_;
  std::vector<SceneNode> nodes_;
  std::vector<const aiNode*> sources_;
};

// By the file's numbers, exactly.
Eigen::Matrix4d to_eigen(const aiMatrix4x4& m);
Eigen::Vector3d to_eigen(const aiVector3D& v);
Eigen::Quaterniond to_eigen(const aiQuaternion& q);

// All clips. Channels of nodes that the file does not have are left out, and so are morph targets.
// Throws ModelError for a key that is not finite, out of order, or a zero rotation.
std::vector<Animation> convert_animations(const aiScene& scene, const NodeTree& tree, const std::string& file);

}  // namespace refitlab
