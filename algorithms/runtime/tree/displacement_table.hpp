// SPDX-License-Identifier: MIT
// A DisplacementTable has, for each ball of reference vertices, balls that hold the displacements of these vertices by each morph
// target (a3_morph_displacement).
#pragma once

#include <span>
#include <vector>

#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// A TargetBall belongs to a target that moves some of the vertices. Those that it does not move have the displacement 0.
struct TargetBall {
  int target;
  Ball3<double> ball;
};

struct DisplacementTable {
  std::vector<std::size_t> first;  // by ball, and one past the last; empty for a mesh without morph targets
  std::vector<TargetBall> balls;   // of one ball: by increasing target

  std::span<const TargetBall> operator[](std::size_t ball) const {
    if (first.empty()) return {};
    return {balls.data() + first[ball], first[ball + 1] - first[ball]};
  }
};

}  // namespace refitlab
