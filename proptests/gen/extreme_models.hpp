// SPDX-License-Identifier: GPL-3.0-or-later
// Makes models at the limits of what a model may be, each in a pose.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct ExtremeModel {
  std::string what;
  refitlab::SkinnedMesh mesh;
  refitlab::Pose pose;
};

// Returns valid models: huge, tiny, both at once, far away, of 1000 joints, of 64 influences, of one joint that moves, with all
// vertices in one point or on one line.
std::vector<ExtremeModel> extreme_models();

// Returns the model with all of its lengths times a factor.
refitlab::SkinnedMesh scaled(refitlab::SkinnedMesh model, double factor);
refitlab::Pose scaled(refitlab::Pose pose, double factor);

}  // namespace proptests::gen
