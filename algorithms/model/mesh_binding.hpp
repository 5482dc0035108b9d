// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes of a model file, each in its place in one reference pose, and the joints that move them.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/scene_conversion.hpp"

namespace refitlab {

// A mesh in its place: its vertices, moved by placement, are in the frame of the reference pose.
struct BoundMesh {
  const aiMesh* mesh;
  Eigen::Matrix4d placement;
  std::vector<int> joints;  // by bone; a mesh without bones has one joint for all of its vertices
};

struct BoundScene {
  std::vector<BoundJoint> joints;  // in the order of their nodes
  std::vector<BoundMesh> meshes;   // in the order of their nodes
};

// Finds joints for all meshes of the tree that have triangles.
//
// The reference pose is the one that the first skinned mesh rests in. A mesh whose offset matrices, of joints that
// others have used, are in another frame is moved to the reference pose; where no one placement makes all of them
// agree, a node gets a joint for each offset. A skinned mesh that shares no joint, and a mesh without bones, are placed
// as the nodes of the file have them relative to the nearest ancestor that is a joint (or else to the first joint);
// the node of a mesh without bones becomes a joint.
// Throws ModelError: no skin, a bone without a node, an offset matrix that is singular or not finite.
BoundScene bind_meshes(const aiScene& scene, const NodeTree& tree, const std::string& file);

}  // namespace refitlab
