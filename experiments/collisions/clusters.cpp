#include "experiments/collisions/clusters.hpp"

#include "algorithms/collide/cluster_collide.hpp"

namespace refitlab {
namespace {

class Clusters : public Detector {
 public:
  explicit Clusters(const Character& character)
      : tree_(character), first_(tree_, Skinning::spherical), second_(tree_, Skinning::spherical) {}

  void pose(const EncounterFrame& frame) override {
    add_frame(counts_);
    first_.begin(frame.first, frame.first_at);
    second_.begin(frame.second, frame.second_at);
  }

  std::vector<TrianglePair> query(Query query) override { return collide(first_, second_, query, tests_, &memory_); }

  DetectorCounts counts() const override {
    DetectorCounts all = counts_;
    add_frame(all);
    all.volume_tests = tests_.ball_tests;
    all.triangle_tests = tests_.triangle_tests;
    return all;
  }

 private:
  void add_frame(DetectorCounts& counts) const {
    for (const ClusterBody* body : {&first_, &second_}) {
      counts.vertices_skinned += body->corners_skinned();
      counts.nodes_refitted += body->nodes_bounded();
    }
  }

  const ClusterTree tree_;
  ClusterBody first_, second_;
  PairMemory memory_;
  QueryCounts tests_;
  DetectorCounts counts_;  // of the frames before this one
};

}  // namespace

std::vector<DetectorKind> cluster_kinds() {
  return {
      {"clusters",
       "boxes around control points, many nodes at a time, down to clusters of up to 256 triangles, which are skinned; "
       "yes/no tries pairs of earlier frames first",
       Origin::own, [](const Character& c) { return std::make_unique<Clusters>(c); }}};
}

}  // namespace refitlab
