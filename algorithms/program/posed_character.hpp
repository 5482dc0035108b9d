// SPDX-License-Identifier: GPL-3.0-or-later
// A PosedCharacter is a character for queries in one pose of a model, whatever its joints and morph targets do there.
#pragma once

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/collide/cluster_body.hpp"

namespace refitlab {

struct PosedCharacter {
  Character character;
  Pose pose;          // of rigid joints; empty if affine has the joints
  AffinePose affine;  // of linear skinning by joints that are not rigid

  // Starts a frame of a body of this character.
  void begin(ClusterBody& body, const RigidTransform<double>& placement) const;
};

// Returns the character at a time of an animation of the model, which must be loaded with Joints::affine and Morphs::moving.
// Morph targets, and the scales of joints in skinning in two phases, are applied to its vertices in double (deformed_vertices).
// Throws ModelError for a pose that the skinning does not take.
PosedCharacter posed_character(Model model, const Animation& animation, double time, Skinning skinning);

}  // namespace refitlab
