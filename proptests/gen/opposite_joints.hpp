// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles anywhere among joints that are turned nearly opposite ways, so that blends of them nearly vanish.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct OppositeJoints {
  refitlab::SkinnedMesh mesh;  // 20 triangles, of two to four joints that all influence each vertex
  refitlab::Pose pose;         // quaternions within a right angle of the first, some twice as far from each other
};
OppositeJoints opposite_joints(unsigned seed);

// "beyond a right angle" if two of its quaternions, with the skinning's signs, are so far apart, else "within a right angle".
const char* label_of(const OppositeJoints& soup);

}  // namespace proptests::gen
