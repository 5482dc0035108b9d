// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle: all pairs of triangles, slow and obvious.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

// The touching pairs of a frame, in increasing order: every pair of triangles whose boxes overlap is decided exactly.
std::vector<TrianglePair> brute_force(const SkinnedMesh& model, const JointSets& sets, const ScenarioFrame& frame,
                                      Skinning skinning);

}  // namespace refitlab
