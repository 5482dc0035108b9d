// SPDX-License-Identifier: GPL-3.0-or-later
// Poses and placements drawn from a standard generator, for scenes whose seed a property draws.
#pragma once

#include <random>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

// Normal noise of this size on the imaginary parts of 1, normalised.
refitlab::Quaternion<double> random_rotation(std::mt19937& random, double spread);

// Every joint turned and moved by itself, neighbours by some 100 degrees against each other at a spread of 0.5.
refitlab::Pose random_pose(const refitlab::SkinnedMesh& model, std::mt19937& random, double spread = 0.5);

// Rotations as files of floats have them: up to 1e-6 off in the square of their length.
void spoil_lengths(refitlab::Pose& pose, std::mt19937& random);

}  // namespace proptests::gen
