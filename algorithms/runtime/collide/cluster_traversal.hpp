// SPDX-License-Identifier: MIT
// ClusterTraversal goes down the wide nodes of two bodies, to the pairs of clusters whose boxes meet.
#pragma once

#include <algorithm>
#include <limits>

#include "algorithms/runtime/collide/cluster_body.hpp"

namespace refitlab {

// Boxes may become smaller while this works: ClusterBody::tighten may cut that of a cluster to its skinned vertices, and opening a
// wide node may cut that of the wide node.
class ClusterTraversal {
 public:
  // All of these must outlive this. hits is working storage.
  ClusterTraversal(ClusterBody& first, ClusterBody& second, ClusterPairs& pairs, QueryCounts& counts, std::vector<int>& hits)
      : first_(first),
        second_(second),
        pairs_(pairs),
        counts_(counts),
        hits_(hits) {}

  // Finds the pairs of triangles that touch. A yes/no query ends with the first clusters in which it finds any. It looks first
  // where boxes reach deepest into each other.
  void run() {
    const Hits tops(*this, first_, 0, pairs_.moved(second_.wide_node_box(0)));
    for (std::size_t i = 0; i < tops.count() && !pairs_.is_done(); ++i) below_second(tops[i], box_at(first_, tops[i]), 0);
    if (!pairs_.is_done()) pairs_.decide();
  }

 private:
  // Hits lists the places in a wide node whose boxes are not apart from a box. The list is on top of a common stack as long as
  // this lives.
  class Hits {
   public:
    Hits(ClusterTraversal& traversal, ClusterBody& body, int wide_node, const Box<float>& box)
        : traversal_(traversal),
          wide_node_(wide_node),
          first_(traversal.top_) {
      const BoxBlock<float>* const boxes = body.wide_node_boxes(wide_node);
      const int count = body.tree().wide_nodes()[wide_node].child_count;
      traversal.counts_.ball_tests += count;
      if (traversal.hits_.size() < first_ + count) traversal.hits_.resize(first_ + count);
      count_ = traversal.kernels_.overlaps(boxes, count, box, traversal.hits_.data() + first_);
      traversal.top_ += count_;
      if (traversal.pairs_.query() == Query::yes_no) put_deepest_first(boxes, box);
    }
    ~Hits() { traversal_.top_ = first_; }
    Hits(const Hits&) = delete;
    std::size_t count() const { return count_; }
    ChildPlace operator[](std::size_t i) const { return {wide_node_, traversal_.hits_[first_ + i]}; }

   private:
    void put_deepest_first(const BoxBlock<float>* boxes, const Box<float>& box) {
      const auto begin = traversal_.hits_.begin() + static_cast<std::ptrdiff_t>(first_);
      const auto end = begin + static_cast<std::ptrdiff_t>(count_);
      auto deepest = begin;
      float depth = -std::numeric_limits<float>::infinity();
      for (auto hit = begin; hit != end; ++hit)
        if (const float of_hit = common_width(get_box(boxes, *hit), box); of_hit > depth) depth = of_hit, deepest = hit;
      if (deepest != end) std::rotate(begin, deepest, deepest + 1);
    }

    ClusterTraversal& traversal_;
    const int wide_node_;
    const std::size_t first_;
    std::size_t count_;
  };

  // Returns the box at a place as it is now, seen from the body's own origin. It may have been larger when the place was listed.
  static Box<float> box_at(ClusterBody& body, ChildPlace at) { return get_box(body.wide_node_boxes(at.wide_node), at.child); }

  // Compares one node of the first body with those in a wide node of the second, and the other way round. box_a is the node's own,
  // and moved_b that of the second body's as seen from the first one's origin.
  void below_second(ChildPlace a, const Box<float>& box_a, int wide_node) {
    const Hits hits(*this, second_, wide_node, pairs_.moved_back(box_a));
    for (std::size_t i = 0; i < hits.count() && !pairs_.is_done(); ++i) nodes(a, hits[i]);
  }
  void below_first(int wide_node, ChildPlace b, const Box<float>& moved_b) {
    const Hits hits(*this, first_, wide_node, moved_b);
    for (std::size_t i = 0; i < hits.count() && !pairs_.is_done(); ++i) nodes(hits[i], b);
  }

  // Compares two nodes whose boxes met when they were listed, and opens the larger one.
  void nodes(ChildPlace at_a, ChildPlace at_b) {
    const WideNodeChild& a = first_.tree().child(at_a);
    const WideNodeChild& b = second_.tree().child(at_b);
    const bool are_clusters = a.wide_node < 0 && b.wide_node < 0;
    // These have boxes of their own, which are compared first.
    if (are_clusters && pairs_.are_skinned(a.cluster, b.cluster)) return pairs_.add(a.cluster, b.cluster);
    const Box<float> box_a = box_at(first_, at_a), box_b = box_at(second_, at_b), moved_b = pairs_.moved(box_b);
    if (are_apart(box_a, moved_b)) return;  // by now
    if (are_clusters) {
      // The second one is skinned only if its bound meets the vertices' box of the first one.
      const Box<float>& exact_a = first_.clusters().cluster(a.cluster).box;
      first_.tighten(a.cluster);
      if (are_apart(exact_a, moved_b)) return;
      pairs_.add(a.cluster, b.cluster);
      second_.tighten(b.cluster);
      return;
    }
    if (b.wide_node < 0 || (a.wide_node >= 0 && box_a.extent() >= box_b.extent())) below_first(a.wide_node, at_b, moved_b);
    else below_second(at_a, box_a, b.wide_node);
  }

  ClusterBody &first_, &second_;
  ClusterPairs& pairs_;
  QueryCounts& counts_;
  std::vector<int>& hits_;  // of which top_ are in use
  std::size_t top_ = 0;
  const ClusterPairKernels& kernels_ = cluster_pair_kernels(best_target());
};

}  // namespace refitlab
