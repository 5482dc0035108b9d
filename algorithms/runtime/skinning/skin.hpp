// SPDX-License-Identifier: MIT
// skin() computes the deformed vertices of a whole model in a pose.
#pragma once

#include "algorithms/runtime/skinning/deformation.hpp"

namespace refitlab {

// Returns the deformed vertices by index, in model space of the animated pose. palette must come from make_skinning_palette
// with the same skinning. Throws ModelError for a deformation that check_deformation refuses, and std::invalid_argument for a
// palette of affine joints unless the skinning is linear.
std::vector<Point3> skin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPalette<double>& palette,
                         Skinning skinning, const Deformation& deformation = {});

// Returns the vertices of the reference pose as the deformation leaves them. Throws ModelError for a deformation that
// check_deformation refuses.
std::vector<Point3> deformed_vertices(const SkinnedMesh& mesh, const JointSets& sets, const Deformation& deformation);

}  // namespace refitlab
