// SPDX-License-Identifier: MIT
// These functions check that the parts of a character from a file fit each other. Refits and queries rely on this without
// checking.
#pragma once

#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// Checks that indices are in range; that nodes are level by level, with the children of a node side by side behind it, and
// with the node's triangles in order; that leaves have the vertices of their triangles; that balls, those of displacements too,
// are finite; and that weights are from 0 to 1. mesh must be valid, and sets must be its own. Throws ModelError that names the
// file, the node and the reason.
void check_tree(const SphereTree& tree, const SkinnedMesh& mesh, const JointSets& sets, const std::string& file);

// Checks the pieces of the nodes in the same way. A table may be empty.
void check_pieces(const PieceTable& table, const SphereTree& tree, const SkinnedMesh& mesh, const JointSets& sets,
                  const std::string& file);

}  // namespace refitlab
