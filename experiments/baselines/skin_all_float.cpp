// SPDX-License-Identifier: GPL-3.0-or-later
// Skins everything in float, cluster by cluster, with the boxes of the clusters in the same registers, and merges these
// bottom-up. Triangles of clusters whose boxes meet are culled, compared and filtered in float, with the skinning's slack in
// the error bound; only pairs that stay unknown are decided on vertices in double.
#include "algorithms/runtime/collide/cluster_traversal.hpp"
#include "experiments/baselines/baselines.hpp"

namespace refitlab {
namespace {

// A SkinnedBody is all of one body in a frame.
class SkinnedBody {
 public:
  explicit SkinnedBody(const ClusterTree& tree) : clusters_(tree, Skinning::spherical), own_(tree.wide_nodes().size()) {
    int blocks = 0;
    for (const WideNode& n : tree.wide_nodes()) first_block_.push_back(blocks), blocks += blocks_of(n.child_count);
    boxes_.resize(blocks);
  }

  const ClusterTree& tree() const { return clusters_.tree(); }
  SkinnedClusters& clusters() { return clusters_; }
  const BoxBlock<float>* wide_node_boxes(int n) const { return &boxes_[first_block_[n]]; }
  const Box<float>& wide_node_box(int n) const { return own_[n]; }
  void tighten(int) {}  // they are the clusters' own

  void refit() {
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

 private:
  SkinnedClusters clusters_;
  std::vector<int> first_block_;
  std::vector<BoxBlock<float>> boxes_;
  std::vector<Box<float>> own_;
};

class SkinAllFloat : public Detector {
 public:
  SkinAllFloat(const Character& character, const ClusterOptions& options)
      : tree_(character, options),
        first_(tree_),
        second_(tree_) {}

  void palette(const ScenarioFrame& frame) override {
    check_pose(tree_.character().mesh, frame.first), check_pose(tree_.character().mesh, frame.second);
    const Point3& origin = frame.first_at.translation;
    first_.clusters().begin(frame.first, frame.first_at, origin);
    second_.clusters().begin(frame.second, frame.second_at, origin);
    first_.clusters().make_all_palettes(), second_.clusters().make_all_palettes();
  }

  void skin() override {
    first_.clusters().skin_all(), second_.clusters().skin_all();
    skinned_ += first_.clusters().vertices_skinned() + second_.clusters().vertices_skinned();
  }

  void refit() override {
    first_.refit(), second_.refit();
    refitted_ += 2 * static_cast<long>(tree_.clusters().size() + tree_.wide_nodes().size());
  }

  std::vector<TrianglePair> query(Query query) override {
    ClusterPairs pairs(first_.clusters(), second_.clusters(), query, counts_, scratch_);
    auto found = ClusterTraversal(first_, second_, pairs, counts_, hits_).run();
    if (query == Query::yes_no && found.size() > 1) found.resize(1);
    return found;
  }

  DetectorCounts counts() const override {
    return {.volume_tests = counts_.ball_tests,
            .triangle_tests = counts_.triangle_tests,
            .vertices_skinned = skinned_,
            .nodes_refitted = refitted_};
  }

 private:
  const ClusterTree tree_;
  SkinnedBody first_, second_;
  QueryCounts counts_;
  ClusterPairScratch scratch_;
  std::vector<int> hits_;
  long skinned_ = 0, refitted_ = 0;
};

}  // namespace

std::unique_ptr<Detector> make_skin_all_float(const Character& character) {
  return std::make_unique<SkinAllFloat>(character, ClusterOptions{});
}
std::unique_ptr<Detector> make_skin_all_float_512(const Character& character) {
  return std::make_unique<SkinAllFloat>(character, ClusterOptions{.most_triangles = 512});
}

}  // namespace refitlab
