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

// Builds the tree top-down. Each node gets the smallest ball of its vertices [Gaertner 1999], and splits where this is least: the
// number of triangles times the sum of the edges of their box, added up over both children. As with trees for ray tracing
// [Goldsmith and Salmon 1987], queries then look at few triangles: a large box that may be anywhere meets a small one the more
// often, the greater the sum of the small one's edges is. The triangles are sorted by centroid along each axis, and each place is
// tried that leaves at least a quarter of them on either side. Then pruning makes it a tree of general order.
// mesh must be valid. Throws std::invalid_argument for triangles_per_leaf < 1.
SphereTree build_sphere_tree(const SkinnedMesh& mesh, const JointSets& sets, const TreeOptions& options = {});

}  // namespace refitlab
