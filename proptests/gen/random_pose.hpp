// SPDX-License-Identifier: GPL-3.0-or-later
// Draws poses and placements from a standard generator, for scenes whose seed a property draws.
#pragma once

#include <random>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

// Draws a rotation: normal noise of this size on the imaginary parts of 1, normalised.
refitlab::Quaternion<double> random_rotation(std::mt19937& random, double spread);

// Draws a placement that turns by any angle, to a place that is about so far away.
refitlab::RigidTransform<double> random_placement(std::mt19937& random, double far = 1);

// Draws one that is far away, where sums of coordinates are rounded, in a fourth of all cases.
refitlab::RigidTransform<double> near_or_far_placement(std::mt19937& random);

// Turns and moves every joint by itself. Neighbours are turned by some 100 degrees against each other at a spread of 0.5.
refitlab::Pose random_pose(const refitlab::SkinnedMesh& model, std::mt19937& random, double spread = 0.5);

// Spoils rotations as files of floats do: the square of their length is up to 1e-6 off.
void spoil_lengths(refitlab::Pose& pose, std::mt19937& random);

}  // namespace proptests::gen
