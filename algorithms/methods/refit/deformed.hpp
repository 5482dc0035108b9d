// SPDX-License-Identifier: MIT
// Balls of the deformed vertices themselves: what a refit is measured against, and the classic way to refit.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/tree/sphere_tree.hpp"

namespace refitlab {

// By node: the smallest ball of the node's deformed vertices ("Optimal" in Table 1).
std::vector<Ball3<double>> optimal_balls(const SphereTree& tree, const NodeVertices& vertices, std::span<const Point3> deformed);

// By node, bottom-up [Brown et al. 2001]: a leaf's smallest ball of its deformed vertices, a parent's of its children.
std::vector<Ball3<double>> refit_bottom_up(const SphereTree& tree, std::span<const Point3> deformed);

}  // namespace refitlab
