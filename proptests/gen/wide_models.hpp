// SPDX-License-Identifier: GPL-3.0-or-later
// Draws small models in a pose from all that validate() and check_pose() accept, above all from its edges.
#pragma once

#include <random>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct WideModel {
  refitlab::SkinnedMesh mesh;
  refitlab::Pose pose;
  int triangles_per_leaf;
  // This is at least any length of the model and of the pose's translations.
  double largest_length;
  // This is the least of those of vertices that are not 0.
  double least_coordinate;
  std::string what;
};

// Draws 1 to most_joints joints (90 if there is no reason for less), all of which, a few or one move a vertex, and 1 to 30
// triangles, some in one leaf. Coordinates and translations are from 0 and the least denormal to 1e40: of one size, of a size
// each, or tiny beside ordinary ones. Vertices are anywhere, repeated, on a line, on a grid, on a sphere, or the six ends of
// axes, where the bound of a ball's image is attained. Quaternions are any, nearly equal, equal, nearly opposite, or half-turns
// about the coordinate axes; they are of unit length in double, as floats have them, or at either end of the tolerance.
WideModel wide_model(std::mt19937& random, int most_joints = 90);

// Returns the quaternion with the squared length 1 + defect, or the nearest to it that check_pose takes.
refitlab::Quaternion<double> of_defect(const refitlab::Quaternion<double>& unit, double defect);

}  // namespace proptests::gen
