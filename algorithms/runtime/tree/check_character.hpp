// SPDX-License-Identifier: MIT
// Whether the parts of a character that was read fit each other: what refits and queries rely on without looking.
#pragma once

#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// Indices in range; nodes level by level, the children of a node side by side behind it, with the node's triangles in order;
// at leaves the vertices of their triangles; balls finite; weights from 0 to 1. mesh is valid, sets are its own. Throws
// ModelError that names the file, the node and the reason.
void check_tree(const SphereTree& tree, const SkinnedMesh& mesh, const JointSets& sets, const std::string& file);

// The same for the pieces of its nodes; a table may be empty.
void check_pieces(const PieceTable& table, const SphereTree& tree, const JointSets& sets, const std::string& file);

}  // namespace refitlab
