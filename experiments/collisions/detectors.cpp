// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/collisions/detectors.hpp"

#include <stdexcept>

#include "experiments/baselines/baselines.hpp"
#include "experiments/collisions/clusters.hpp"
#include "experiments/collisions/floors.hpp"
#include "experiments/collisions/on_demand.hpp"

namespace refitlab {

const std::vector<DetectorKind>& detector_kinds() {
  static const std::vector<DetectorKind> all = [] {
    std::vector<DetectorKind> kinds = on_demand_kinds();
    std::vector<DetectorKind> bounded;
    for (const auto& others : {baseline_kinds(), engine_kinds()})
      for (const DetectorKind& kind : others) bounded.push_back(bounded_kind(kind));
    for (const auto& more : {cluster_kinds(), baseline_kinds(), engine_kinds(), bounded, floor_kinds()})
      kinds.insert(kinds.end(), more.begin(), more.end());
    return kinds;
  }();
  return all;
}

const DetectorKind& detector_kind(const std::string& name) {
  for (const DetectorKind& kind : detector_kinds())
    if (kind.name == name) return kind;
  throw std::invalid_argument("no detector named '" + name + "'");
}

}  // namespace refitlab
