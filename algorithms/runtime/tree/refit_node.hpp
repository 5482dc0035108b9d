// RefitNode: all that refitting one node may look at. The vertices are not among it.
#pragma once

#include <span>

#include "algorithms/runtime/skinning/skinning_pose.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// A piece of a node: vertices of one joint-set, and the corners of a polytope that holds all their weights. In the paper a
// node has one piece a joint-set, and the polytope is the weight box cut by sum w = 1 (paper 4.1).
struct NodeJointSet {
  int joint_set;
  int first_weight;  // of the corners, rows of one weight a joint, in a shared pool
  int corner_count;  // m
  int reference = 0;  // in RefitNode::piece_references, if it has any
};

template <class S>
struct RefitNode {
  Ball3<S> reference;                        // S = [p, r]: encloses the node's vertices in the reference posture
  std::span<const NodeJointSet> joint_sets;  // J: the pieces that together are the node's vertices
  const S* corner_weights;                   // the pool
  const SkinningPose<S>& pose;               // of the frame
  // A shared pool of balls; that of a piece (NodeJointSet::reference) encloses its vertices alone and has its center, up to
  // rounding, in S. Empty: S for all of them.
  std::span<const Ball3<S>> piece_references = {};

  // c_k of one of its pieces, by position in the joint-set.
  std::span<const S> corner(const NodeJointSet& set, int k) const {
    const std::size_t n = pose.joint_count(set.joint_set);
    return {corner_weights + set.first_weight + k * n, n};
  }
  // Whether the piece is one vertex: a ball of radius 0 that moves rigidly.
  bool is_vertex(const NodeJointSet& set) const {
    return !piece_references.empty() && set.corner_count == 1 && piece_references[set.reference].radius == S(0);
  }
  const Ball3<S>& piece_reference(std::size_t piece) const {
    return piece_references.empty() ? reference : piece_references[joint_sets[piece].reference];
  }
};

}  // namespace refitlab
