// SPDX-License-Identifier: GPL-3.0-or-later
// These balls hold the displacements by morph targets.
#pragma once

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "algorithms/runtime/tree/displacement_table.hpp"

namespace refitlab {

// Returns the smallest balls of the displacements of the vertices in each list, which is not empty, by each target that moves one
// of them. The table is empty for a mesh without morph targets.
DisplacementTable build_displacements(const SkinnedMesh& mesh, std::span<const std::vector<int>> lists);

}  // namespace refitlab
