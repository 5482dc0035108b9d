// SPDX-License-Identifier: GPL-3.0-or-later
// Random rigs in the shape of glTF files: right ones, with everything that makes a rig awkward.
#pragma once

#include "proptests/gen/rigged_gltf.hpp"

namespace proptests::gen {

// What a rig has; its numbers follow from the seed. Binds and poses are unrelated: a rig need not look like
// anything.
struct RigTraits {
  int joints = 1;                // at least one
  double scale = 1;              // of the node above all others
  bool mirrored = false;         // by that node
  bool many_influences = false;  // eight a vertex in place of four
  bool second_skin = false;      // over the same joints, bound in a frame that is moved against the first
  bool split_joint = false;      // of the second skin, whose last joint is bound differently
  bool other_joints = false;     // the second skin has a joint of its own only
  bool loose_mesh = false;       // without bones, on a node of uneven scale
  unsigned seed = 0;
};

RigTraits draw_traits();  // within a property

// One clip, which turns and moves all nodes, at 2 to 4 key times each.
RiggedGltf random_rig(const RigTraits& traits);

}  // namespace proptests::gen
