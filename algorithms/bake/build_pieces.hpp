// SPDX-License-Identifier: GPL-3.0-or-later
// These are the pieces of a tree's nodes. A piece is the vertices of a joint-set in a node, or a part of them where that is
// tighter. Its polytope is the hull of their weight vectors wherever the hull has no more weight vertices than the weight box,
// and otherwise the box.
#pragma once

#include "algorithms/runtime/tree/piece_table.hpp"

namespace refitlab {

struct PieceOptions {
  // A joint-set's vertices are split in two where that makes the pieces smaller, until a node has this many pieces. If it is 1,
  // nothing is split, and there is one piece for each joint-set.
  int most_pieces = 1;
  // A node of many joint-sets may have this many pieces for each joint-set, rounded down, if that is more.
  double pieces_per_joint_set = 1;
  // Bounding a piece of few vertices can cost more than skinning it. If a piece has at most this many vertices for each of
  // its control points (m weight vertices have m(m+1)(m+2)/6), each of its vertices becomes a piece of its own. Such a
  // piece is a ball of radius 0 with one weight vertex, and its bound is the skinned vertex itself. A node of a single
  // rigid piece keeps it, because it is bounded exactly as it is. 0 means never.
  double vertices_per_control_point = 0;
  // A piece whose vertices morph targets take farther from each other than this share of the node's radius, all targets with the
  // weight 1, is listed by its vertices too, if there are at most most_displaced_vertices. Its ball would be as much larger as
  // they may be apart.
  double least_displacement = 0.02;
  std::size_t most_displaced_vertices = 0;
  // Joints that scale stretch the ball of a rigid piece by as much as any of its diameters, though its vertices may all lie along
  // another. Such a piece is listed by its vertices if these are no more than this, and a node of rigid pieces alone is split
  // into as many as stretched_pieces. 0 is for joints that do not scale.
  std::size_t most_stretched_vertices = 0;
  int stretched_pieces = 1;
  // The widest extent is split first, of places and of weights. A full change of weight counts as this share of the node's
  // radius.
  double weight_extent = 1;
};

// Returns the pieces of all nodes of the tree. vertices are those of the nodes; mesh and sets are those of the tree.
PieceTable build_pieces(const SphereTree& tree, const NodeVertices& vertices, const SkinnedMesh& mesh, const JointSets& sets,
                        const PieceOptions& options);

}  // namespace refitlab
