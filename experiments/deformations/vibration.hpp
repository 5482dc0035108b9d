// SPDX-License-Identifier: GPL-3.0-or-later
// This simulates flesh that vibrates after a jolt, on a model in its reference pose. Reduced deformations are made from it.
#pragma once

#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// Returns the displacements of all vertices by frame. Frames are evenly spaced in time. Vertices are unit masses, edges are
// springs that are linear about the reference pose, and weak springs pull vertices back to their places. A jolt, which is a speed
// that varies smoothly over the body, sets them off. The largest displacement is a twentieth of the model's longest side.
std::vector<std::vector<Point3>> vibration(const SkinnedMesh& mesh, int frames);

}  // namespace refitlab
