// SPDX-License-Identifier: MIT
// Skinning a whole model: the deformed vertices of a pose.
#pragma once

#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// By vertex, in model space of the animated pose. palette must come from make_skinning_palette with the same skinning.
std::vector<Point3> skin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPalette<double>& palette,
                         Skinning skinning);

}  // namespace refitlab
