// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios are scenes of two copies of a model that walk past each other, for collision queries (paper 5, Table 2).
#pragma once

#include "experiments/baselines/detector.hpp"
#include "experiments/scenes/scenes.hpp"

namespace refitlab {

struct Scenario {
  std::string name;  // far, near, light, heavy, worst
  std::vector<ScenarioFrame> frames;
};

// WalkPast is how two walkers pass. Both move along z, `lateral` apart along x, and the second one is turned about y to face the
// first. Over the frames the centers of their deformed vertices' smallest balls go from a fifth of a root radius before each
// other to as much behind. The first clip plays once for the first walker, and half a clip later for the second; without clips
// both twist (figure_twist) up to the full angle.
class WalkPast {
 public:
  WalkPast(const AnimatedCharacter& character, int frames);
  std::vector<ScenarioFrame> at(double lateral) const;
  // Returns frames in which both have their centers at the origin all the time.
  std::vector<ScenarioFrame> in_place() const;

 private:
  struct Step {
    Pose first, second;
    Point3 first_center, second_center;
    double forward;
  };
  std::vector<Step> steps_;
};

// Returns five scenarios. far: the roots are disjoint. near: they overlap in the middle, but no triangles touch. light: the
// median is about 50 touching pairs. heavy: it is about 850, or lateral is 0 if that has fewer. worst: both are in one place all
// the time (the paper's worst-case scenario). The distances are found by bisection on 12 frames; that of near then grows until no
// triangles touch in any of its own.
std::vector<Scenario> scenarios(const AnimatedCharacter& character, int frames);

}  // namespace refitlab
