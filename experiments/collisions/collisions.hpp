// The collision experiment: what queries between two walkers look at and cost, by scene and refit variant.
#pragma once

#include "experiments/collisions/encounters.hpp"
#include "experiments/speed/timing.hpp"

namespace refitlab {

struct CollisionSettings {
  int frames = 100;  // of each encounter
  SpeedSettings speed;
};

// Means over the frames of an encounter.
struct CollisionResult {
  std::string model, scene, variant;  // that is, contender
  Query query;
  double pairs = 0, ball_tests = 0, triangle_tests = 0, balls_refitted = 0, vertices_skinned = 0;
  std::vector<double> share_refitted;  // by level - 1, of both trees' balls
  double us_per_frame = 0;             // the joint-sets' data of the frame, refits, skinning and tests
  double ratio_to_repaired = 0;        // of the time
};

// All spherical contenders that are sound, in all encounters of the character, full and yes/no. Throws std::logic_error if
// two variants find different pairs.
std::vector<CollisionResult> run_collisions(const Character& character, const CollisionSettings& settings);

void write_collisions(const std::vector<CollisionResult>& results, const std::string& path);

}  // namespace refitlab
