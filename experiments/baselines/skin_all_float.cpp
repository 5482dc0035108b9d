// SPDX-License-Identifier: GPL-3.0-or-later
// Skins everything in float. Triangles of clusters whose boxes meet are culled, compared and filtered in float, with the skinning's
// slack in the error bound; only pairs that stay unknown are decided on vertices in double.
#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/skinned_body.hpp"

namespace refitlab {
namespace {

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
