// SPDX-License-Identifier: GPL-3.0-or-later
// Walkers are men who walk straight ahead in a square, each in a direction and from a time of the clip of his own.
#pragma once

#include <vector>

#include "algorithms/model/model.hpp"

namespace refitlab {

// How the men of a scene stand at first.
struct Spacing {
  const char* scene;
  double edge;   // of the square that each has for himself, in metres
  bool is_even;  // each in the middle of his own, not anywhere
};

class Walkers {
 public:
  static constexpr int frames = 4;
  static constexpr unsigned seed = 7;

  Walkers(const Clip& walk, int count, const Spacing& spacing);
  int count() const { return static_cast<int>(poses_[0].size()); }
  const std::vector<Pose>& poses(int frame) const { return poses_[frame]; }
  const std::vector<RigidTransform<double>>& placements(int frame) const { return placements_[frame]; }

 private:
  std::vector<Pose> poses_[frames];
  std::vector<RigidTransform<double>> placements_[frames];
};

}  // namespace refitlab
