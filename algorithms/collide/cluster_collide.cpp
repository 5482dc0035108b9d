#include "algorithms/collide/cluster_collide.hpp"

#include "algorithms/collide/triangles_meet.hpp"

namespace refitlab {
namespace {

bool are_apart(const Box6& a, const Box6& b) {
  for (int i = 0; i < 3; ++i)
    if (a[3 + i] < b[i] || b[3 + i] < a[i]) return true;
  return false;
}

class ClusterTraversal {
 public:
  ClusterTraversal(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts)
      : first_(first), second_(second), query_(query), counts_(counts) {}

  std::vector<TrianglePair> run() {
    const Fan& top = first_.tree().fans()[0];
    first_.fan_boxes(0);
    for (int i = 0; i < top.child_count && !is_done(); ++i) below_second(child(first_, 0, i), first_.child_box(0, i), 0);
    return std::move(found_);
  }

 private:
  static FanChild child(const ClusterBody& body, int fan, int i) {
    return body.tree().children()[body.tree().fans()[fan].first_child + i];
  }
  bool is_done() const { return query_ == Query::yes_no && !found_.empty(); }

  int overlaps(const BoxBlock* blocks, int count, const Box6& box, std::vector<int>& out) {
    counts_.ball_tests += count;
    out.resize(count);
    const int found = kernels_.overlaps(blocks, count, box.data(), out.data());
    out.resize(found);
    return found;
  }

  // One node of the first body against those in a fan of the second.
  void below_second(const FanChild& a, const Box6& box, int fan) {
    std::vector<int> hits;
    overlaps(second_.fan_boxes(fan), second_.tree().fans()[fan].child_count, box, hits);
    for (const int i : hits) {
      if (is_done()) return;
      nodes(a, box, child(second_, fan, i), second_.child_box(fan, i));
    }
  }
  void below_first(int fan, const FanChild& b, const Box6& box) {
    std::vector<int> hits;
    overlaps(first_.fan_boxes(fan), first_.tree().fans()[fan].child_count, box, hits);
    for (const int i : hits) {
      if (is_done()) return;
      nodes(child(first_, fan, i), first_.child_box(fan, i), b, box);
    }
  }

  static double extent(const Box6& b) { return (b[3] - b[0]) + (b[4] - b[1]) + (b[5] - b[2]); }

  // Two nodes whose boxes meet: the larger one is opened.
  void nodes(const FanChild& a, const Box6& box_a, const FanChild& b, const Box6& box_b) {
    if (a.fan < 0 && b.fan < 0) return clusters(a.cluster, b.cluster);
    if (b.fan < 0 || (a.fan >= 0 && extent(box_a) >= extent(box_b)))
      below_first(a.fan, b, box_b);
    else
      below_second(a, box_a, b.fan);
  }

  void clusters(int a, int b) {
    const Box6 &box_a = first_.cluster_box(a), &box_b = second_.cluster_box(b);
    if (are_apart(box_a, box_b)) return;
    const int count_a = first_.tree().clusters()[a].group_count, count_b = second_.tree().clusters()[b].group_count;
    if (overlaps(first_.group_boxes(a), count_a, box_b, groups_a_) == 0) return;
    for (const int g : groups_a_) {
      Box6 box;
      const BoxBlock& block = first_.group_boxes(a)[g / 8];
      for (int k = 0; k < 6; ++k) box[k] = block.side[k][g % 8];
      overlaps(second_.group_boxes(b), count_b, box, groups_b_);
      for (const int h : groups_b_) {
        groups(a, g, b, h);
        if (is_done()) return;
      }
    }
  }

  void groups(int a, int g, int b, int h) {
    const TriangleGroup &group_a = first_.tree().groups()[first_.tree().clusters()[a].first_group + g],
                        &group_b = second_.tree().groups()[second_.tree().clusters()[b].first_group + h];
    const BoxBlock &boxes_a = first_.triangle_boxes(a, g), &boxes_b = second_.triangle_boxes(b, h);
    for (int i = 0; i < group_a.count; ++i) {
      Box6 box;
      for (int k = 0; k < 6; ++k) box[k] = boxes_a.side[k][i];
      int hits[group_size];
      const int found = kernels_.overlaps(&boxes_b, group_b.count, box.data(), hits);
      for (int k = 0; k < found; ++k) {
        ++counts_.triangle_tests;
        if (!triangles_meet(first_.triangle(a, g, i), second_.triangle(b, h, hits[k]))) continue;
        found_.push_back({group_a.triangles[i], group_b.triangles[hits[k]]});
        if (query_ == Query::yes_no) return;
      }
    }
  }

  ClusterBody &first_, &second_;
  const Query query_;
  QueryCounts& counts_;
  const BoxKernels& kernels_ = box_kernels(best_target());
  std::vector<TrianglePair> found_;
  std::vector<int> groups_a_, groups_b_;
};

}  // namespace

std::vector<TrianglePair> collide(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts) {
  return ClusterTraversal(first, second, query, counts).run();
}

}  // namespace refitlab
