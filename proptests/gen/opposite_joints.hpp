// SPDX-License-Identifier: GPL-3.0-or-later
// Draws triangles anywhere among joints that are turned nearly opposite ways, so that blends of them nearly vanish.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct OppositeJoints {
  // It has 20 triangles, of two to four joints that all influence each vertex.
  refitlab::SkinnedMesh mesh;
  // Its quaternions are within a right angle of the first, some twice as far from each other.
  refitlab::Pose pose;
};
OppositeJoints opposite_joints(unsigned seed);

// Returns "beyond a right angle" if two of its quaternions, with the skinning's signs, are so far apart, and otherwise "within a
// right angle".
const char* label_of(const OppositeJoints& soup);

}  // namespace proptests::gen
