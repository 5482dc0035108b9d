// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/baselines/skinned_body.hpp"

namespace refitlab {

SkinnedBody::SkinnedBody(const ClusterTree& tree) : clusters_(tree, Skinning::spherical), own_(tree.wide_nodes().size()) {
  int blocks = 0;
  for (const WideNode& n : tree.wide_nodes()) first_block_.push_back(blocks), blocks += blocks_of(n.child_count);
  boxes_.resize(blocks);
}

void SkinnedBody::refit() {
  for (int n = static_cast<int>(own_.size()); n-- > 0;) {  // children come after their parents
    own_[n] = Box<float>::empty();
    for (int i = 0; i < tree().wide_nodes()[n].child_count; ++i) {
      const WideNodeChild& child = tree().child(n, i);
      const Box<float>& box = child.cluster >= 0 ? clusters_.cluster(child.cluster).box : own_[child.wide_node];
      put_box(&boxes_[first_block_[n]], i, box);
      own_[n].merge(box);
    }
  }
}

}  // namespace refitlab
