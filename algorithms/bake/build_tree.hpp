// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the sphere tree of a skinned mesh.
#pragma once

#include "algorithms/runtime/tree/sphere_tree.hpp"

namespace refitlab {

struct TreeOptions {
  int triangles_per_leaf = 1;  // at most this many; at least 1
  // A node whose radius is more than this share of its parent's is removed, and its children take its place. Leaves stay.
  double prune_ratio = 0.9;
};

// Builds the tree top-down. Each node splits at the median of its triangles' centroids along their longest extent, and gets
// the smallest ball of its vertices [Gaertner 1999]. Then pruning makes it a tree of general order.
// mesh must be valid. Throws std::invalid_argument for triangles_per_leaf < 1.
SphereTree build_sphere_tree(const SkinnedMesh& mesh, const JointSets& sets, const TreeOptions& options = {});

}  // namespace refitlab
