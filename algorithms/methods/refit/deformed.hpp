// SPDX-License-Identifier: MIT
// These are balls of the deformed vertices themselves. Refits are measured against the smallest ones, and the others are the
// classic way to refit.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/tree/sphere_tree.hpp"

namespace refitlab {

// Returns, by node, the smallest ball of the node's deformed vertices ("Optimal" in Table 1).
std::vector<Ball3<double>> optimal_balls(const SphereTree& tree, const NodeVertices& vertices, std::span<const Point3> deformed);

// Returns balls by node, made bottom-up [Brown et al. 2001]. A leaf has the smallest ball of its deformed vertices, and a parent
// that of its children's balls.
std::vector<Ball3<double>> refit_bottom_up(const SphereTree& tree, std::span<const Point3> deformed);

}  // namespace refitlab
