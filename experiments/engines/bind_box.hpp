// SPDX-License-Identifier: GPL-3.0-or-later
// These are the box of the bind pose, and a box scaled by a guess.
#pragma once

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

inline Box<double> bind_box(const SkinnedMesh& mesh) { return box_around<double>(mesh.vertices); }

// Scales a box about its center.
template <class S>
Box<S> scaled(const Box<S>& box, const S& factor) {
  const Vec<S, 3> center = box.center(), half = box.edges() * S(factor / S(2));
  return {center - half, center + half};
}

}  // namespace refitlab
