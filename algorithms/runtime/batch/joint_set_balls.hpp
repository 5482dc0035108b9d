// SPDX-License-Identifier: MIT
// Balls around the vertices of joint-sets in the reference pose, whose centers are what vertices in float are seen from
// (float_palette.hpp).
#pragma once

#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// By joint-set. The centers are those of the boxes around the vertices.
std::vector<Ball3<double>> joint_set_balls(const SkinnedMesh& mesh, const JointSets& sets);

}  // namespace refitlab
