// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a tree's nodes: the vertices of a joint-set in a node, or parts of them where these are tighter, and the hull
// of their weight vectors in place of the weight box wherever the hull has no more corners.
#pragma once

#include "algorithms/runtime/tree/piece_table.hpp"

namespace refitlab {

struct PieceOptions {
  // A joint-set's vertices are split in two where that makes the pieces smaller, until a node has this many pieces. 1: no
  // splitting, one piece a joint-set.
  int most_pieces = 1;
  // The same for nodes of many joint-sets: this many pieces for each of them, rounded down, if that is more.
  double pieces_per_joint_set = 1;
  // A piece of few vertices is dearer to bound than to skin: one with at most this many vertices for each of its control
  // points (m corners have m(m+1)(m+2)/6) becomes a piece a vertex, a ball of radius 0 with one corner, whose bound is
  // the skinned vertex itself. A node of a single rigid piece stays: it is bounded exactly as it is. 0: never.
  double vertices_per_control_point = 0;
};

PieceTable build_pieces(const SphereTree& tree, const NodeVertices& vertices, const SkinnedMesh& mesh, const JointSets& sets,
                        const PieceOptions& options);

}  // namespace refitlab
