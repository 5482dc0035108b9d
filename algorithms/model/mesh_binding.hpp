// SPDX-License-Identifier: GPL-3.0-or-later
// A BoundScene has the meshes of a scene, each in its place in one reference pose, and the joints that move them.
#pragma once

#include <vector>

#include "algorithms/model/scene.hpp"

namespace refitlab {

// A BoundPrimitive is a primitive that a node shows, in its place. Its vertices, moved by placement, are in the frame of the
// reference pose.
struct BoundPrimitive {
  int shown, primitive;  // of scene.shown[shown]'s mesh
  Eigen::Matrix4d placement;
  std::vector<int> joints;  // by joint of the skin; a mesh without a skin has one joint for all of its vertices
};

// A RepeatedMesh is one that an earlier node shows with the same skin and the same morph weights. Both are indices of
// scene.shown.
struct RepeatedMesh {
  int shown, first;
};

struct BoundScene {
  std::vector<BoundJoint> joints;          // in the order of their nodes
  std::vector<BoundPrimitive> primitives;  // in the order of the scene
  std::vector<RepeatedMesh> repeated;      // whose primitives are bound for the first one alone
};

// Finds joints for all primitives of the scene that have triangles.
//
// The reference pose is the one that the first skinned primitive rests in. A primitive whose offset matrices, of joints
// that others have used, are in another frame is moved to the reference pose; where no one placement makes all of them
// agree, a node gets a joint for each offset. A skinned primitive that shares no joint, and one without a skin, are placed
// as the nodes of the file have them relative to the nearest ancestor that is a joint (or else to the first joint);
// the node of a mesh without a skin becomes a joint.
// Throws ModelError if there is no skin, and for an offset matrix that is singular, not affine or not finite.
BoundScene bind_meshes(const Scene& scene);

}  // namespace refitlab
