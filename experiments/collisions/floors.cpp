// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/collisions/floors.hpp"

#include <algorithm>
#include <map>

#include "algorithms/runtime/collide/cluster_pairs.hpp"

namespace refitlab {
namespace {

enum class Told { boxes_meet, triangles_touch };

class Floor : public Detector {
 public:
  Floor(const Character& character, Told told)
      : told_(told),
        tree_(character),
        first_(tree_, Skinning::spherical),
        second_(tree_, Skinning::spherical) {}

  // It looks where to look when it sees a frame for the first time, which must therefore not be timed.
  void palette(const ScenarioFrame& frame) override {
    auto known = pairs_.find(&frame);
    if (known == pairs_.end()) known = pairs_.emplace(&frame, look(frame)).first;
    now_ = &known->second;
    begin(frame);
  }

  std::vector<TrianglePair> query(Query query) override {
    ClusterPairs clusters(first_, second_, query, counts_, scratch_);
    for (const ClusterPair& pair : *now_) {
      clusters.add(pair.first, pair.second);
      if (told_ == Told::triangles_touch && query == Query::yes_no) clusters.decide();
      if (clusters.is_done()) break;
    }
    if (!clusters.is_done()) clusters.decide();
    skinned_ += first_.vertices_skinned() + second_.vertices_skinned();
    return clusters.take_found();
  }

  DetectorCounts counts() const override {
    return {.volume_tests = 0, .triangle_tests = counts_.triangle_tests, .vertices_skinned = skinned_, .nodes_refitted = 0};
  }

 private:
  void begin(const ScenarioFrame& frame) {
    const Point3& origin = frame.first_at.translation;
    first_.begin(frame.first, frame.first_at, origin);
    second_.begin(frame.second, frame.second_at, origin);
  }

  std::vector<ClusterPair> look(const ScenarioFrame& frame) {
    begin(frame);
    QueryCounts uncounted;
    ClusterPairs clusters(first_, second_, Query::full, uncounted, scratch_);
    std::vector<ClusterPair> meeting;
    const int count = static_cast<int>(tree_.clusters().size());
    for (int a = 0; a < count; ++a)
      for (int b = 0; b < count; ++b)
        if (!are_apart(first_.cluster(a).box, clusters.moved(second_.cluster(b).box))) meeting.push_back({a, b});
    if (told_ == Told::boxes_meet) return meeting;
    for (const ClusterPair& pair : meeting) clusters.add(pair.first, pair.second);
    clusters.decide();
    std::vector<ClusterPair> touching;
    for (const ClusterPair& pair : clusters.touching())
      if (std::find(touching.begin(), touching.end(), pair) == touching.end()) touching.push_back(pair);
    return touching;
  }

  const Told told_;
  const ClusterTree tree_;
  SkinnedClusters first_, second_;
  ClusterPairScratch scratch_;
  QueryCounts counts_;
  std::map<const ScenarioFrame*, std::vector<ClusterPair>> pairs_;
  const std::vector<ClusterPair>* now_ = nullptr;
  long skinned_ = 0;
};

DetectorKind kind_of(const char* name, const char* description, Told told) {
  return {name, description, Origin::floor, [told](const Character& c) { return std::make_unique<Floor>(c, told); }, true};
}

}  // namespace

std::vector<DetectorKind> floor_kinds() {
  return {
      kind_of("floor_of_boxes",
              "no detector: clusters that is told which pairs of clusters' boxes meet, and skins and compares these alone; as "
              "if bounds were tight and free",
              Told::boxes_meet),
      kind_of("floor_of_contacts",
              "no detector: the same, told which pairs of clusters touch; no culling of clusters can be faster",
              Told::triangles_touch)};
}

}  // namespace refitlab
