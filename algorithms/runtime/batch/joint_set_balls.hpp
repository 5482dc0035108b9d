// SPDX-License-Identifier: MIT
// These balls enclose the vertices of joint-sets in the reference pose. Vertices in float are seen from their centers
// (float_palette.hpp).
#pragma once

#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns the balls by joint-set. The centers are those of the boxes around the vertices.
std::vector<Ball3<double>> joint_set_balls(const SkinnedMesh& mesh, const JointSets& sets);

}  // namespace refitlab
