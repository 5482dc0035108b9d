// SPDX-License-Identifier: GPL-3.0-or-later
// A SkinnedBody is what a baseline makes of a body in a frame: all of it is skinned in float, cluster by cluster, with the boxes of
// the clusters in the same registers, and these are merged bottom-up. ClusterTraversal goes through it.
#pragma once

#include "algorithms/runtime/collide/cluster_traversal.hpp"

namespace refitlab {

class SkinnedBody {
 public:
  // tree must outlive this.
  explicit SkinnedBody(const ClusterTree& tree);

  const ClusterTree& tree() const { return clusters_.tree(); }
  // A frame begins with these clusters' begin.
  SkinnedClusters& clusters() { return clusters_; }
  // These are seen from clusters().origin(), once refit() has made them.
  const BoxBlock<float>* wide_node_boxes(int n) const { return &boxes_[first_block_[n]]; }
  const Box<float>& wide_node_box(int n) const { return own_[n]; }
  void tighten(int) {}  // boxes are those of the clusters' vertices already

  // Merges the boxes of the clusters, all of which must have been skinned in this frame.
  void refit();

 private:
  SkinnedClusters clusters_;
  std::vector<int> first_block_;
  std::vector<BoxBlock<float>> boxes_;
  std::vector<Box<float>> own_;
};

}  // namespace refitlab
