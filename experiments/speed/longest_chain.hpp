// SPDX-License-Identifier: GPL-3.0-or-later
// The longest chain of operations of a refit, each of which waits for the one before, says how long one ball takes at least, in however
// many lanes it is computed.
#pragma once

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "algorithms/runtime/tree/sphere_tree.hpp"
#include "experiments/speed/chained.hpp"

namespace refitlab {

// Returns the nanoseconds of the longest chain of a node's refit, averaged over all nodes: that of the linear refit if the palette is
// for linear skinning, else that of Algorithm 1 repaired, both with mean balls, in the order in which the templates compute.
double longest_chain(const SphereTree& tree, const SkinningPalette<double>& palette, bool is_linear, const Latencies& latencies);

}  // namespace refitlab
