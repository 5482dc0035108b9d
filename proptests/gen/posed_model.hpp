// SPDX-License-Identifier: GPL-3.0-or-later
// Small rigged models in a pose: a random tree of joints, a handful of vertices, joints that only turn.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "proptests/gen/rigid.hpp"

namespace proptests::gen {

struct PosedModel {
  refitlab::SkinnedMesh mesh;
  refitlab::Pose pose;                    // composed along the tree, as the paper has it: a joint turns about its origin
  std::vector<RationalQuaternion> turns;  // the local rotation of each joint, exactly
};

// 1 to 6 joints, vertices of 1 to 5 influences. Unturned joints, half-turns and equal origins come up often. Numbers
// are the doubles nearest to small rationals; a rotation's sign is as it comes.
rc::Gen<PosedModel> posed_model();

void showValue(const PosedModel& posed, std::ostream& out);

}  // namespace proptests::gen
