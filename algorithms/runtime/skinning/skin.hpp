// SPDX-License-Identifier: MIT
// Skinning of a whole model: it computes the deformed vertices of a pose.
#pragma once

#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// Returns the deformed vertices by index, in model space of the animated pose. palette must come from make_skinning_palette
// with the same skinning.
std::vector<Point3> skin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPalette<double>& palette,
                         Skinning skinning);

}  // namespace refitlab
