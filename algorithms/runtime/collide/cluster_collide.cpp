// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_collide.hpp"

#include <bit>
#include <optional>

#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

class ClusterTraversal {
 public:
  ClusterTraversal(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts)
      : first_(first),
        second_(second),
        query_(query),
        counts_(counts) {}

  // For yes/no, all pairs of the first clusters that have any.
  std::vector<TrianglePair> run() {
    const Hits tops(*this, first_.wide_node_boxes(0), first_.tree().wide_nodes()[0].child_count, second_.wide_node_box(0));
    for (std::size_t i = 0; i < tops.count() && !is_done(); ++i) {
      const int child = tops[i];
      below_second(first_.tree().child(0, child), first_.child_box(0, child), 0);
    }
    return std::move(found_);
  }

 private:
  // Which boxes of some blocks are not apart from a box. The list is on top of a common stack as long as this lives.
  class Hits {
   public:
    Hits(ClusterTraversal& traversal, const BoxBlock<double>* blocks, int count, const Box<double>& box)
        : stack_(traversal.hits_),
          first_(stack_.size()) {
      traversal.counts_.ball_tests += count;
      stack_.resize(first_ + count);
      count_ = traversal.kernels_.overlaps(blocks, count, box, stack_.data() + first_);
      stack_.resize(first_ + count_);
    }
    ~Hits() { stack_.resize(first_); }
    Hits(const Hits&) = delete;
    std::size_t count() const { return count_; }
    int operator[](std::size_t i) const { return stack_[first_ + i]; }

   private:
    std::vector<int>& stack_;
    const std::size_t first_;
    std::size_t count_;
  };

  bool is_done() const { return query_ == Query::yes_no && !found_.empty(); }

  // One node of the first body against those in a wide node of the second.
  void below_second(const WideNodeChild& a, const Box<double>& box, int wide_node) {
    const Hits hits(*this, second_.wide_node_boxes(wide_node), second_.tree().wide_nodes()[wide_node].child_count, box);
    for (std::size_t i = 0; i < hits.count() && !is_done(); ++i)
      nodes(a, box, second_.tree().child(wide_node, hits[i]), second_.child_box(wide_node, hits[i]));
  }
  void below_first(int wide_node, const WideNodeChild& b, const Box<double>& box) {
    const Hits hits(*this, first_.wide_node_boxes(wide_node), first_.tree().wide_nodes()[wide_node].child_count, box);
    for (std::size_t i = 0; i < hits.count() && !is_done(); ++i)
      nodes(first_.tree().child(wide_node, hits[i]), first_.child_box(wide_node, hits[i]), b, box);
  }

  // Two nodes whose boxes meet: the larger one is opened.
  void nodes(const WideNodeChild& a, const Box<double>& box_a, const WideNodeChild& b, const Box<double>& box_b) {
    if (a.wide_node < 0 && b.wide_node < 0) return clusters(a.cluster, b.cluster);
    if (b.wide_node < 0 || (a.wide_node >= 0 && box_a.extent() >= box_b.extent())) below_first(a.wide_node, b, box_b);
    else below_second(a, box_a, b.wide_node);
  }

  void clusters(int a, int b) {
    const Box<double>&box_a = first_.cluster_box(a), &box_b = second_.cluster_box(b);
    if (are_apart(box_a, box_b)) return;
    pairs_.clear();
    const Hits groups_a(*this, first_.group_boxes(a), first_.tree().clusters()[a].group_count, box_b);
    for (std::size_t i = 0; i < groups_a.count(); ++i) {
      const int g = groups_a[i];
      const Hits groups_b(*this, second_.group_boxes(b), second_.tree().clusters()[b].group_count,
                          get_box(first_.group_boxes(a), g));
      for (std::size_t k = 0; k < groups_b.count(); ++k) groups(a, g, b, groups_b[k]);
    }
    triangles(a, b);
  }

  // Lists the pairs of triangles whose boxes meet.
  void groups(int a, int g, int b, int h) {
    const TriangleGroup &group_a = first_.tree().group(a, g), &group_b = second_.tree().group(b, h);
    for (std::uint64_t pairs =
             kernels_.overlapping_pairs(first_.triangle_boxes(a, g), group_a.count, second_.triangle_boxes(b, h), group_b.count);
         pairs; pairs &= pairs - 1) {
      const int bit = std::countr_zero(pairs), i = bit / 8, k = bit % 8;
      pairs_.push_back({group_a.corners[i], group_b.corners[k], group_a.triangles[i], group_b.triangles[k]});
    }
  }

  void triangles(int a, int b) {
    counts_.triangle_tests += static_cast<long>(pairs_.size());
    const PaddedVertex *corners_a = first_.corners(a), *corners_b = second_.corners(b);
    answers_.resize(pairs_.size());
    kernels_.filter_pairs(corners_a, corners_b, pairs_.data(), static_cast<int>(pairs_.size()), answers_.data());
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const bool meet = answers_[p] == Filtered::unknown
                            ? boxed_triangles_meet(corners_of(corners_a, pairs_[p].a), corners_of(corners_b, pairs_[p].b))
                            : answers_[p] == Filtered::meet;
      if (meet) found_.push_back({pairs_[p].first, pairs_[p].second});
    }
  }

  static TrianglePoints corners_of(const PaddedVertex* corners, const std::array<std::uint16_t, 3>& places) {
    const auto point = [&](int i) {
      return Point3(corners[places[i]].of[0], corners[places[i]].of[1], corners[places[i]].of[2]);
    };
    return {point(0), point(1), point(2)};
  }

  ClusterBody &first_, &second_;
  const Query query_;
  QueryCounts& counts_;
  const BoxKernels& kernels_ = box_kernels(best_target());
  std::vector<TrianglePair> found_;
  std::vector<int>& hits_ = first_.query_scratch().hits;
  std::vector<TrianglePairCandidate>& pairs_ = first_.query_scratch().pairs;
  std::vector<Filtered>& answers_ = first_.query_scratch().answers;
};

// The first of the remembered pairs that still touches.
std::optional<TrianglePair> still_touching(ClusterBody& first, ClusterBody& second, const PairMemory& memory,
                                           QueryCounts& counts) {
  for (const TrianglePair& pair : memory.pairs()) {
    ++counts.triangle_tests;
    if (triangles_meet(first.triangle(pair.first), second.triangle(pair.second))) return pair;
  }
  return {};
}

}  // namespace

std::vector<TrianglePair> collide(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts, PairMemory* memory) {
  const DefaultFloatEnvironment environment;
  if (memory && query == Query::yes_no)
    if (const auto pair = still_touching(first, second, *memory, counts)) {
      memory->remember(*pair);
      return {*pair};
    }
  if (!memory || !memory->are_near) {  // near bodies are told apart by their wide nodes, if at all
    ++counts.ball_tests;
    if (are_apart(first.motion_bound(), second.motion_bound())) return {};
  }
  auto pairs = ClusterTraversal(first, second, query, counts).run();
  if (memory) {
    memory->are_near = !are_apart(first.wide_node_box(0), second.wide_node_box(0));
    memory->remember(pairs);
  }
  if (query == Query::yes_no && pairs.size() > 1) pairs.resize(1);
  return pairs;
}

}  // namespace refitlab
