// SPDX-License-Identifier: MIT
// This is the fast query for the touching triangles of two skinned characters. It uses wide nodes of boxes, and clusters
// (cluster_tree.hpp).
#pragma once

#include "algorithms/runtime/collide/cluster_body.hpp"
#include "algorithms/runtime/collide/collide.hpp"
#include "algorithms/runtime/collide/pair_memory.hpp"

namespace refitlab {

// Returns the pairs of triangles with a point in common, as their doubles in the world have it: exactly, and in no particular
// order. A yes/no query returns one of them, if there is any. first and second are different bodies,
// which may share a tree. They keep what was made for further queries in the frame, so a body is in one query at a time; trees
// are in as many as one likes. If there is a memory, it belongs to these two bodies, in this order; a yes/no query then first
// looks into the clusters that touched in earlier frames. Throws std::logic_error for a body that has begun no frame, and
// std::invalid_argument for two that are the same.
std::vector<TrianglePair> collide(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts,
                                  PairMemory* memory = nullptr);

}  // namespace refitlab
