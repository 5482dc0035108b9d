// SPDX-License-Identifier: GPL-3.0-or-later
// Small models in a pose, drawn from all that validate() and check_pose() accept, their edges above all.
#pragma once

#include <random>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct WideModel {
  refitlab::SkinnedMesh mesh;
  refitlab::Pose pose;
  int triangles_per_leaf;
  double largest_length;    // at least any length of the model and of the pose's translations
  double least_coordinate;  // of those of vertices that are not 0
  std::string what;
};

// 1 to most_joints joints (90 if there is no reason for less), all of which, a few or one move a vertex; 1 to 30 triangles,
// some in one leaf. Coordinates and translations from 0 and the least denormal to 1e40: of one size, of a size each, or
// tiny beside ordinary ones. Vertices anywhere, repeated, on a line, on a grid, on a sphere, or the six ends of axes, where
// the bound of a ball's image is attained. Quaternions any, nearly equal, equal, nearly opposite, or half-turns about
// the coordinate axes; of unit length in double, as floats have them, or at either end of the tolerance.
WideModel wide_model(std::mt19937& random, int most_joints = 90);

// The quaternion with the squared length 1 + defect, or the nearest to it that check_pose takes.
refitlab::Quaternion<double> of_defect(const refitlab::Quaternion<double>& unit, double defect);

}  // namespace proptests::gen
