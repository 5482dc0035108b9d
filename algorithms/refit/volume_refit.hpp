// Refitting a node to any convex volume: the volume around the control balls, whose hull holds the node's vertices.
#pragma once

#include "algorithms/refit/control_hull.hpp"

namespace refitlab {

// Holds the node's vertices under spherical blending. Volume::around(balls, how...) is a convex volume that encloses
// the balls.
template <class Volume, class S, class... How>
Volume refit_volume(const RefitNode<S>& node, ControlLists<S>& lists, const How&... how) {
  return Volume::around(control_balls(node, lists), how...);
}

}  // namespace refitlab
