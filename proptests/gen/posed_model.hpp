// SPDX-License-Identifier: GPL-3.0-or-later
// Draws small rigged models in a pose: a random tree of joints, a handful of vertices, and joints that only turn.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "proptests/gen/rigid.hpp"

namespace proptests::gen {

struct PosedModel {
  refitlab::SkinnedMesh mesh;
  // It is composed along the tree, as the paper has it: a joint turns about its origin.
  refitlab::Pose pose;
  std::vector<RationalQuaternion> turns;  // the local rotation of each joint, exactly
};

// Draws 1 to 6 joints, and vertices of 1 to 5 influences. Unturned joints, half-turns and equal origins come up often. Numbers
// are the doubles nearest to small rationals; a rotation's sign is as it comes.
rc::Gen<PosedModel> posed_model();

void showValue(const PosedModel& posed, std::ostream& out);

}  // namespace proptests::gen
