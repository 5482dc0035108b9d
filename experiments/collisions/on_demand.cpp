// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/collisions/on_demand.hpp"

#include "experiments/scenes/methods.hpp"

namespace refitlab {
namespace {

class OnDemand : public CountingDetector {
 public:
  OnDemand(const Character& character, const Method& method)
      : first_(character, *method.variant, method.options),
        second_(character, *method.variant, method.options) {
    counts_.refitted_by_level.resize(character.tree.level_count());
  }

  void palette(const ScenarioFrame& frame) override {
    keep_frame();
    first_.begin(frame.first);
    second_.begin(frame.second);
    first_at_ = frame.first_at, second_at_ = frame.second_at;
  }

  std::vector<TrianglePair> query(Query query) override {
    return collide({first_, first_at_}, {second_, second_at_}, query, tests_);
  }

 private:
  void add_frame(DetectorCounts& counts) const override {
    for (const Body* body : {&first_, &second_}) {
      counts.vertices_skinned += body->vertices_skinned();
      for (std::size_t l = 0; l < counts.refitted_by_level.size(); ++l) {
        counts.refitted_by_level[l] += body->refits().refitted_by_level()[l];
        counts.nodes_refitted += body->refits().refitted_by_level()[l];
      }
    }
  }

  Body first_, second_;
  RigidTransform<double> first_at_, second_at_;
};

// The major methods are the paper's refit, the default refit by itself and through BVH cuts, and the tightest refit.
bool is_major(const Method& c) {
  return c.variant->name == default_variant(Skinning::spherical).name || c.name == "spherical_repaired" ||
         c.name == "control_many_pieces";
}

DetectorKind kind_of(const Method& c) {
  return {c.name, c.description, Origin::own,
          [&c](const Character& character) { return std::make_unique<OnDemand>(character, c); }, !is_major(c)};
}

}  // namespace

std::vector<DetectorKind> on_demand_kinds() {
  std::vector<DetectorKind> kinds;
  for (const Method& c : methods())  // queries go top-down: what takes the children first has nothing to take
    if (c.variant->sound && c.variant->skinning == Skinning::spherical && !c.options.children_first) kinds.push_back(kind_of(c));
  return kinds;
}

DetectorKind linear_on_demand() { return kind_of(method("linear")); }

}  // namespace refitlab
