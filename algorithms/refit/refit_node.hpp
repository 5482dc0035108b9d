// RefitNode: all that refitting one node may look at. The vertices are not among it.
#pragma once

#include <span>

#include "algorithms/skinning/skinning_pose.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// One joint-set of one node: the corners of its weight bounds (paper 4.1), rows of one weight a joint, in a shared pool.
struct NodeJointSet {
  int joint_set;
  int first_weight;  // in the pool
  int corner_count;  // m
};

template <class S>
struct RefitNode {
  Ball3<S> reference;                        // S = [p, r]: encloses the node's vertices in the reference posture
  std::span<const NodeJointSet> joint_sets;  // J, those of the node's vertices
  const S* corner_weights;                   // the pool
  std::span<const JointSetPose<S>> pose;     // of the frame, by joint-set

  // c_k of one of its joint-sets, by position in the joint-set.
  std::span<const S> corner(const NodeJointSet& set, int k) const {
    const std::size_t n = pose[set.joint_set].transforms.size();
    return {corner_weights + set.first_weight + k * n, n};
  }
};

}  // namespace refitlab
