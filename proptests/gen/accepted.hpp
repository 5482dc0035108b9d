// SPDX-License-Identifier: GPL-3.0-or-later
// Rotations, placements and scenes at the edges of what the interface accepts: rotations off unit length, lengths from
// denormal to huge, and vertices put where a bound is attained.
#pragma once

#include <random>
#include <string>

#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace proptests::gen {

// How long quaternions are, whose squared length may be off by 1e-6.
enum class UnitLength { as_doubles, as_floats, anything, longest, shortest };
UnitLength random_unit_length(std::mt19937& random);
refitlab::Quaternion<double> with_length(const refitlab::Quaternion<double>& unit, UnitLength length, std::mt19937& random);
refitlab::Pose with_lengths(refitlab::Pose pose, UnitLength length, std::mt19937& random);

// Turned any way, of any length of its quaternion, and moved by this length about, or not at all.
refitlab::RigidTransform<double> accepted_placement(std::mt19937& random, double far);

refitlab::Skinning random_skinning(std::mt19937& random);

// A corner on each side of a center along each axis, all equally far from it, and joints that all turn alike about it. So
// the vertices are the extreme points of any bound that knows a ball around them. Turns are half turns about the axes,
// where a quaternion that is too long stretches most, or any.
struct Attained {
  refitlab::SkinnedMesh mesh;  // an octahedron
  refitlab::Pose pose;
  refitlab::RigidTransform<double> placement;
  double size;  // more than the lengths that bounds are made from: about center, radius, joints' translations
  std::string what;
};
struct AttainedOptions {
  double unit = 1;  // of all lengths
  double far = 0;   // how far the placement moves, in the same units
  int joints = 0;   // 0: any of 1 to 90
};
Attained attained(std::mt19937& random, const AttainedOptions& options = {});

// A single triangle of joints that do not move, from its tip at the origin along an axis this or that way. Moved so that
// the tip is the farthest vertex of a body along that axis, it touches the body in that very double and nowhere else.
refitlab::SkinnedMesh needle(int axis, int sign, double length, int joints);

}  // namespace proptests::gen
