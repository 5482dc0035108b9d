// SPDX-License-Identifier: GPL-3.0-or-later
// Walkers are men who walk straight ahead, each in a direction and from a time of the clip of his own.
#pragma once

#include <vector>

#include "algorithms/model/model.hpp"

namespace refitlab {

// How the men of a scene stand at first.
struct Spacing {
  const char* scene;
  double edge;   // of the square that each has for himself, in metres
  bool is_even;  // each in the middle of his own square, not anywhere in that of all
};

class Walkers {
 public:
  static constexpr int frames_of_a_start = 4;
  static constexpr double metres_per_second = 1.2, frames_per_second = 30;
  static constexpr unsigned seed = 7;

  // walk is a clip of a walk ahead, along z, on the spot, which begins again where it ends. The men start in a square so many times,
  // each time elsewhere, and walk for some frames.
  Walkers(const Clip& walk, int count, const Spacing& spacing, int starts);

  int count() const { return static_cast<int>(poses_[0].size()); }
  int frames() const { return static_cast<int>(poses_.size()); }
  const std::vector<Pose>& poses(int frame) const { return poses_[frame]; }
  // They turn men about y and move them in the plane of x and z, in metres.
  const std::vector<RigidTransform<double>>& placements(int frame) const { return placements_[frame]; }

 private:
  std::vector<std::vector<Pose>> poses_;
  std::vector<std::vector<RigidTransform<double>>> placements_;
};

}  // namespace refitlab
