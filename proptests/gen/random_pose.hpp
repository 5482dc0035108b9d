// SPDX-License-Identifier: GPL-3.0-or-later
// Draws poses and placements from a standard generator, for scenes whose seed a property draws.
#pragma once

#include <random>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

// Draws a rotation: normal noise of this size on the imaginary parts of 1, normalised.
refitlab::Quaternion<double> random_rotation(std::mt19937& random, double spread);

// Turns and moves every joint by itself. Neighbours are turned by some 100 degrees against each other at a spread of 0.5.
refitlab::Pose random_pose(const refitlab::SkinnedMesh& model, std::mt19937& random, double spread = 0.5);

// Spoils rotations as files of floats do: the square of their length is up to 1e-6 off.
void spoil_lengths(refitlab::Pose& pose, std::mt19937& random);

}  // namespace proptests::gen
