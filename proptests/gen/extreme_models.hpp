// SPDX-License-Identifier: GPL-3.0-or-later
// Models at the ends of what a model may be, each in a pose.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct ExtremeModel {
  std::string what;
  refitlab::SkinnedMesh mesh;
  refitlab::Pose pose;
};

// Valid ones: huge, tiny, both at once, far away, of 1000 joints, of 64 influences, of one joint that moves, all
// vertices in one point or on one line.
std::vector<ExtremeModel> extreme_models();

// The model and all of its lengths times a factor.
refitlab::SkinnedMesh scaled(refitlab::SkinnedMesh model, double factor);
refitlab::Pose scaled(refitlab::Pose pose, double factor);

}  // namespace proptests::gen
