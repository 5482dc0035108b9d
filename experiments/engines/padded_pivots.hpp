// SPDX-License-Identifier: GPL-3.0-or-later
// Padded pivots are a box around the joints' pivots in a pose, padded by one length. It is the most by which the mesh's box at
// rest extends beyond that of the pivots at rest.
//
// OpenUSD computes this for skinned prims. UsdSkelSkinningQuery::ComputeExtentsPadding computes the length, which its comment
// calls approximate, and UsdSkelComputeJointsExtent the box. It is not conservative. The suite whole_character_boxes has the
// smallest rig on which it fails, which has one joint and one vertex: the length is the vertex's greatest coordinate from the
// pivot, and a turn brings its whole distance along one axis. With two joints the length may even be 0: the other pivot is beyond
// the vertex at rest, and not when it has turned.
#pragma once

#include "algorithms/runtime/balls/box.hpp"

namespace refitlab {

// Returns the length. pivots is the box of the pivots at rest, and mesh is that of the mesh at rest.
template <class S>
S pivot_padding(const Box<S>& pivots, const Box<S>& mesh) {
  return max_of<S>(S(0), beyond_box(mesh, pivots));
}

// Returns the padded box. pivots is the box of the pivots in the pose.
template <class S>
Box<S> padded_pivots(Box<S> pivots, const S& padding) {
  pivots.grow(padding);
  return pivots;
}

}  // namespace refitlab
