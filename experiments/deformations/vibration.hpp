// SPDX-License-Identifier: GPL-3.0-or-later
// Flesh that vibrates after a jolt: a simulation of a model in its reference pose, for reduced deformations made from it.
#pragma once

#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// Returns the displacements of all vertices by frame, the frames evenly spaced in time. Vertices are unit masses, edges are springs,
// linear about the reference pose, and weak springs pull vertices back to their places. A jolt, which is a speed that varies
// smoothly over the body, sets them off. The largest displacement is a twentieth of the model's longest side.
std::vector<std::vector<Point3>> vibration(const SkinnedMesh& mesh, int frames);

}  // namespace refitlab
