// SPDX-License-Identifier: MIT
// BD-tree [James and Pai 2004, "BD-tree: output-sensitive collision detection for reduced deformable models"] has balls of
// vertices v_0 + sum q_k d_k, for reduced coordinates q.
//
// A node's ball is its ball at rest, whose center moves by sum q_k m_k and whose radius grows by sum |q_k| s_k. m_k is the mean
// of the vertices' displacements d_k, and s_k the distance of the farthest of these from the mean. This is a3_morph_displacement
// (i) with mean balls in place of the smallest balls that our bake takes. So DeformedReference refits both, with the same slack.
#pragma once

#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// Returns the character with BD-tree's balls of displacements in its nodes. It has no pieces: BD-tree has one ball a node.
Character bd_tree(const Character& character);

}  // namespace refitlab
