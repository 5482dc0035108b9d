// SPDX-License-Identifier: MIT
// ClusterTraversal goes down the wide nodes of two bodies, to the pairs of clusters whose boxes meet.
#pragma once

#include <algorithm>
#include <limits>

#include "algorithms/runtime/collide/cluster_pairs.hpp"

namespace refitlab {

// A Body has a tree(), and boxes in float around the vertices below, seen from the origin of its SkinnedClusters and with four
// roundings of their coordinates to spare: wide_node_boxes(n), which are those of a wide node's children, in blocks, and
// wide_node_box(n), which is that around all of them. tighten(cluster) may put the box of a skinned cluster among these.
template <class Body>
class ClusterTraversal {
 public:
  // All of these must outlive this. hits is working storage.
  ClusterTraversal(Body& first, Body& second, ClusterPairs& pairs, QueryCounts& counts, std::vector<int>& hits)
      : first_(first),
        second_(second),
        pairs_(pairs),
        counts_(counts),
        hits_(hits) {}

  // Returns the pairs of triangles that touch. A yes/no query ends with the first clusters that have any. It looks first where boxes
  // reach deepest into each other.
  std::vector<TrianglePair> run() {
    const Box<float> whole = pairs_.moved(second_.wide_node_box(0));
    const Hits tops(*this, first_, 0, whole);
    for (std::size_t i = 0; i < tops.count() && !pairs_.is_done(); ++i)
      below_second(first_.tree().child(0, tops[i]), child_box(first_, 0, tops[i]), 0);
    if (!pairs_.is_done()) pairs_.decide();
    return std::move(pairs_.found());
  }

 private:
  // Hits lists the boxes of a wide node that are not apart from a box. The list is on top of a common stack as long as this
  // lives.
  class Hits {
   public:
    Hits(ClusterTraversal& traversal, Body& body, int wide_node, const Box<float>& box)
        : stack_(traversal.hits_),
          first_(stack_.size()) {
      const BoxBlock<float>* const boxes = body.wide_node_boxes(wide_node);  // which may throw, and nothing is on the stack yet
      const int count = body.tree().wide_nodes()[wide_node].child_count;
      traversal.counts_.ball_tests += count;
      stack_.resize(first_ + count);
      count_ = traversal.kernels_.overlaps(boxes, count, box, stack_.data() + first_);
      stack_.resize(first_ + count_);
      if (traversal.pairs_.query() == Query::yes_no) put_deepest_first(boxes, box);
    }
    ~Hits() { stack_.resize(first_); }
    Hits(const Hits&) = delete;
    std::size_t count() const { return count_; }
    int operator[](std::size_t i) const { return stack_[first_ + i]; }

   private:
    void put_deepest_first(const BoxBlock<float>* boxes, const Box<float>& box) {
      const auto begin = stack_.begin() + static_cast<std::ptrdiff_t>(first_);
      auto deepest = begin;
      float depth = -std::numeric_limits<float>::infinity();
      for (auto hit = begin; hit != stack_.end(); ++hit)
        if (const float of_hit = common_width(get_box(boxes, *hit), box); of_hit > depth) depth = of_hit, deepest = hit;
      if (deepest != stack_.end()) std::rotate(begin, deepest, deepest + 1);
    }

    std::vector<int>& stack_;
    const std::size_t first_;
    std::size_t count_;
  };

  static Box<float> child_box(Body& body, int wide_node, int i) { return get_box(body.wide_node_boxes(wide_node), i); }
  // Returns the box of a child as it is now. Before, it was the given box.
  static Box<float> newest(Body& body, const WideNodeChild& child, const Box<float>& box) {
    if (child.cluster < 0) return box;
    const Cluster& cluster = body.tree().clusters()[child.cluster];
    return child_box(body, cluster.wide_node, cluster.child);
  }

  // Compares one node of the first body with those in a wide node of the second, and the other way round.
  void below_second(const WideNodeChild& a, const Box<float>& box, int wide_node) {
    const Hits hits(*this, second_, wide_node, pairs_.moved_back(box));
    for (std::size_t i = 0; i < hits.count() && !pairs_.is_done(); ++i)
      nodes(a, newest(first_, a, box), second_.tree().child(wide_node, hits[i]), child_box(second_, wide_node, hits[i]));
  }
  void below_first(int wide_node, const WideNodeChild& b, const Box<float>& box) {
    const Hits hits(*this, first_, wide_node, pairs_.moved(box));
    for (std::size_t i = 0; i < hits.count() && !pairs_.is_done(); ++i)
      nodes(first_.tree().child(wide_node, hits[i]), child_box(first_, wide_node, hits[i]), b, newest(second_, b, box));
  }

  // Compares two nodes whose boxes met when they were listed, and opens the larger one. Each box is seen from its own body's
  // origin.
  void nodes(const WideNodeChild& a, const Box<float>& box_a, const WideNodeChild& b, const Box<float>& box_b) {
    if (are_apart(box_a, pairs_.moved(box_b))) return;  // by now
    if (a.wide_node < 0 && b.wide_node < 0) {
      pairs_.add(a.cluster, b.cluster);
      first_.tighten(a.cluster), second_.tighten(b.cluster);
      return;
    }
    if (b.wide_node < 0 || (a.wide_node >= 0 && box_a.extent() >= box_b.extent())) below_first(a.wide_node, b, box_b);
    else below_second(a, box_a, b.wide_node);
  }

  Body &first_, &second_;
  ClusterPairs& pairs_;
  QueryCounts& counts_;
  std::vector<int>& hits_;
  const ClusterPairKernels& kernels_ = cluster_pair_kernels(best_target());
};

}  // namespace refitlab
