// SPDX-License-Identifier: MIT
// A RefitNode has all data that refitting one node may use. The vertices are not among them.
#pragma once

#include <span>

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// A piece of a node has some vertices of one joint-set, and the weight vertices of a polytope that holds all their weights. In
// the paper, a node has one piece for each joint-set, and the polytope is the weight box cut by sum w = 1 (paper 4.1).
struct NodePiece {
  int joint_set;
  int first_weight;         // of the weight vertices: rows of one weight a joint, in a shared pool
  int weight_vertex_count;  // m
  int reference = 0;        // the index in RefitNode::piece_references, if there are any
};

template <class S>
struct RefitNode {
  Ball3<S> reference;                 // S = [p, r]: encloses the node's vertices in the reference pose
  std::span<const NodePiece> pieces;  // J: the pieces that together are the node's vertices
  const S* weight_vertices;           // the pool
  const SkinningPalette<S>& palette;  // of the frame
  // This is a shared pool of balls. The ball of a piece (NodePiece::reference) encloses the piece's vertices alone, and has its
  // center in S, up to rounding. If the pool is empty, all pieces use S.
  std::span<const Ball3<S>> piece_references = {};

  // Returns the weight vertex c_k of one of the node's pieces, by position in the joint-set.
  std::span<const S> weight_vertex(const NodePiece& set, int k) const {
    const std::size_t n = palette.joint_count(set.joint_set);
    return {weight_vertices + set.first_weight + k * n, n};
  }
  // Says whether the piece is one vertex. It has one weight vertex and a ball of radius 0.
  bool is_vertex(const NodePiece& set) const {
    return !piece_references.empty() && set.weight_vertex_count == 1 && piece_references[set.reference].radius == S(0);
  }
  const Ball3<S>& piece_reference(std::size_t piece) const {
    return piece_references.empty() ? reference : piece_references[pieces[piece].reference];
  }
};

}  // namespace refitlab
