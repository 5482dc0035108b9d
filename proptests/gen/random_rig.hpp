// SPDX-License-Identifier: GPL-3.0-or-later
// Draws random rigs in the shape of glTF files. They are right, with everything that makes a rig awkward.
#pragma once

#include "proptests/gen/rigged_gltf.hpp"

namespace proptests::gen {

// Says what a rig has. Its numbers follow from the seed. Binds and poses are unrelated: a rig need not look like anything.
struct RigTraits {
  int joints = 1;                // at least one
  double scale = 1;              // of the node above all others
  bool mirrored = false;         // by that node
  bool many_influences = false;  // eight a vertex in place of four
  // The second skin is over the same joints, bound in a frame that is moved against the first.
  bool second_skin = false;
  // The last joint of the second skin is bound differently.
  bool split_joint = false;
  // The second skin has one joint of its own, and no other.
  bool other_joints = false;
  // This mesh has no bones, and is on a node of uneven scale.
  bool loose_mesh = false;
  unsigned seed = 0;
};

RigTraits draw_traits();  // within a property

// Draws a rig with one clip, which turns and moves all nodes, at 2 to 4 key times each.
RiggedGltf random_rig(const RigTraits& traits);

}  // namespace proptests::gen
