// SPDX-License-Identifier: MIT
// RefitNode: all that refitting one node may look at. The vertices are not among it.
#pragma once

#include <span>

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// A piece of a node: vertices of one joint-set, and the corners of a polytope that holds all their weights. In the paper a
// node has one piece a joint-set, and the polytope is the weight box cut by sum w = 1 (paper 4.1).
struct NodePiece {
  int joint_set;
  int first_weight;         // of the corners, rows of one weight a joint, in a shared pool
  int weight_vertex_count;  // m
  int reference = 0;        // in RefitNode::piece_references, if it has any
};

template <class S>
struct RefitNode {
  Ball3<S> reference;                 // S = [p, r]: encloses the node's vertices in the reference pose
  std::span<const NodePiece> pieces;  // J: the pieces that together are the node's vertices
  const S* weight_vertices;           // the pool
  const SkinningPalette<S>& palette;  // of the frame
  // A shared pool of balls; that of a piece (NodePiece::reference) encloses its vertices alone and has its center, up to
  // rounding, in S. Empty: S for all of them.
  std::span<const Ball3<S>> piece_references = {};

  // c_k of one of its pieces, by position in the joint-set.
  std::span<const S> corner(const NodePiece& set, int k) const {
    const std::size_t n = palette.joint_count(set.joint_set);
    return {weight_vertices + set.first_weight + k * n, n};
  }
  // Whether the piece is one vertex: a ball of radius 0 that moves rigidly.
  bool is_vertex(const NodePiece& set) const {
    return !piece_references.empty() && set.weight_vertex_count == 1 && piece_references[set.reference].radius == S(0);
  }
  const Ball3<S>& piece_reference(std::size_t piece) const {
    return piece_references.empty() ? reference : piece_references[pieces[piece].reference];
  }
};

}  // namespace refitlab
