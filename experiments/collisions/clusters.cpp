// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/collisions/clusters.hpp"

#include "algorithms/runtime/collide/cluster_collide.hpp"

namespace refitlab {
namespace {

class Clusters : public CountingDetector {
 public:
  Clusters(const Character& character, bool has_memory)
      : has_memory_(has_memory),
        tree_(character),
        first_(tree_, Skinning::spherical),
        second_(tree_, Skinning::spherical) {}

  void palette(const ScenarioFrame& frame) override {
    keep_frame();
    first_.begin(frame.first, frame.first_at);
    second_.begin(frame.second, frame.second_at);
  }

  void forget() override { memory_ = {}; }

  std::vector<TrianglePair> query(Query query) override {
    return collide(first_, second_, query, tests_, has_memory_ ? &memory_ : nullptr);
  }

 private:
  void add_frame(DetectorCounts& counts) const override {
    for (const ClusterBody* body : {&first_, &second_}) {
      counts.vertices_skinned += body->vertices_skinned();
      counts.nodes_refitted += body->nodes_bounded();
    }
  }

  const bool has_memory_;
  const ClusterTree tree_;
  ClusterBody first_, second_;
  PairMemory memory_;
};

}  // namespace

std::vector<DetectorKind> cluster_kinds() {
  return {{"clusters",
           "boxes that hold all that the joints can make of many nodes at a time, down to clusters of up to 256 triangles, which "
           "are skinned and compared in float as by skin_all_float; "
           "the pair is remembered from frame to frame: what touched is tried first, and where most of both bodies is reached, "
           "they are "
           "skinned whole",
           Origin::own, [](const Character& c) { return std::make_unique<Clusters>(c, true); }},
          {"clusters_without_memory", "clusters, each frame by itself", Origin::own,
           [](const Character& c) { return std::make_unique<Clusters>(c, false); }}};
}

}  // namespace refitlab
