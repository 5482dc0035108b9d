// SPDX-License-Identifier: GPL-3.0-or-later
// The collision experiment measures what finding the touching triangles of two walkers costs, by scene and detector.
#pragma once

#include <array>

#include "experiments/collisions/scenarios.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

struct CollisionSettings {
  int frames = 100;  // of each scenario
  SpeedSettings speed;
  bool all_detectors = false;  // the minor ones too
  bool first_model_only = false;
};

// These are the stages of a detector, in their order.
inline constexpr const char* stage_names[] = {"pose", "skinning", "refit", "query"};
using StageTimes = std::array<double, std::size(stage_names)>;

// A CollisionResult has means over the frames of a scenario.
struct CollisionResult {
  std::string model, pose, scene, detector;  // pose: the clip that both walkers play, or "twist"
  Origin origin;
  Query query;
  double differing_pairs = 0;  // of detectors that may have some (DetectorKind::tolerated_share)
  double pairs = 0, volume_tests = 0, triangle_tests = 0, nodes_refitted = 0, vertices_skinned = 0;
  std::vector<double> share_refitted;  // by level - 1, of both trees' balls; where the detector refits on demand
  double us_per_frame = 0;             // from poses to pairs
  StageTimes stages_us{};              // the same in stages, of passes by themselves
  // These are the ratios of the time to those of the fastest engine here, of the faster of the baselines that skin everything
  // in float, and of spherical_repaired.
  double ratio_to_engine = 0, ratio_to_skin_all = 0, ratio_to_repaired = 0;
};

// PairLists are by frame. Each list is sorted.
using PairLists = std::vector<std::vector<TrianglePair>>;

// Measures the given detectors in a scenario. Throws std::logic_error that names the detector and the frame if it finds other
// pairs than expected, or in a query for one pair none of these, beyond the tolerated share of its kind.
std::vector<CollisionResult> measure(const AnimatedCharacter& character, const Scenario& scenario, Query query,
                                     const std::vector<const DetectorKind*>& kinds, const PairLists& expected,
                                     const SpeedSettings& speed);

// Measures the detectors in all scenarios of the character, with full and yes/no queries, against brute force.
std::vector<CollisionResult> run_collisions(const AnimatedCharacter& character, const CollisionSettings& settings);

void write_collisions(const std::vector<CollisionResult>& results, const std::string& path);

const char* name_of(Query query);

}  // namespace refitlab
