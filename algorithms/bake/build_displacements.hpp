// SPDX-License-Identifier: GPL-3.0-or-later
// These balls hold the displacements by morph targets.
//
// Boxes beside them, of which the smaller bound would count, do not pay. In the default run of experiments/deformations they
// would make one displaced ball of seven smaller, by 0.4 % on average, and the worst level's radius of the default refits by 0.1
// % at most.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "algorithms/runtime/tree/displacement_table.hpp"

namespace refitlab {

// Returns the smallest balls of the displacements of the vertices in each list, which is not empty, by each target that moves one
// of them. The table is empty for a mesh without morph targets.
DisplacementTable build_displacements(const SkinnedMesh& mesh, std::span<const std::vector<int>> lists);

}  // namespace refitlab
