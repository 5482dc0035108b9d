// SPDX-License-Identifier: GPL-3.0-or-later
// Skins everything in float, cluster by cluster, with the boxes of the clusters. Triangles of clusters whose boxes meet are culled,
// compared and filtered in float, with the skinning's slack in the error bound; only pairs that stay unknown are decided on vertices
// in double.
#include "algorithms/runtime/collide/cluster_pairs.hpp"
#include "experiments/baselines/baselines.hpp"

namespace refitlab {
namespace {

class SkinAllFloat : public Detector {
 public:
  SkinAllFloat(const Character& character, const ClusterOptions& options)
      : tree_(character, options),
        first_(tree_, Skinning::spherical),
        second_(tree_, Skinning::spherical) {}

  void palette(const ScenarioFrame& frame) override {
    check_pose(tree_.character().mesh, frame.first), check_pose(tree_.character().mesh, frame.second);
    const Point3& origin = frame.first_at.translation;
    first_.begin(frame.first, frame.first_at, origin);
    second_.begin(frame.second, frame.second_at, origin);
    first_.make_all_palettes(), second_.make_all_palettes();
  }

  void skin() override {
    first_.skin_all(), second_.skin_all();
    skinned_ += first_.vertices_skinned() + second_.vertices_skinned();
    boxes_made_ += first_.clusters_skinned() + second_.clusters_skinned();
  }

  std::vector<TrianglePair> query(Query query) override {
    ClusterPairs pairs(first_, second_, query, counts_, scratch_);
    pairs.add_all();
    return pairs.take_found();
  }

  DetectorCounts counts() const override {
    return {.volume_tests = counts_.ball_tests,
            .triangle_tests = counts_.triangle_tests,
            .vertices_skinned = skinned_,
            .nodes_refitted = boxes_made_};
  }

 private:
  const ClusterTree tree_;
  SkinnedClusters first_, second_;
  QueryCounts counts_;
  ClusterPairScratch scratch_;
  long skinned_ = 0, boxes_made_ = 0;
};

}  // namespace

std::function<Maker> skin_all_float_maker(int most_triangles) {
  return [most_triangles](const Character& character) {
    return std::make_unique<SkinAllFloat>(character, ClusterOptions{.most_triangles = most_triangles});
  };
}

}  // namespace refitlab
