// SPDX-License-Identifier: MIT
// Which triangles of two skinned characters touch: the fast query, over wide nodes of boxes and clusters (cluster_tree.hpp).
#pragma once

#include "algorithms/runtime/collide/cluster_body.hpp"
#include "algorithms/runtime/collide/collide.hpp"
#include "algorithms/runtime/collide/pair_memory.hpp"

namespace refitlab {

// As collide() of sphere trees: the same pairs, also in no particular order. first and second are different bodies,
// which may share a tree; they keep what was made for further queries in the frame. With a memory, which belongs to
// these two, a yes/no query first tries the pairs of earlier frames.
std::vector<TrianglePair> collide(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts,
                                  PairMemory* memory = nullptr);

}  // namespace refitlab
