// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle tries all pairs of triangles, which is slow and obvious.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

// Returns the touching pairs of a frame in increasing order. Every pair of triangles whose boxes overlap is decided exactly.
std::vector<TrianglePair> brute_force(const SkinnedMesh& model, const JointSets& sets, const ScenarioFrame& frame,
                                      Skinning skinning);

}  // namespace refitlab
