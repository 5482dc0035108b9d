// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rotations, placements and scenes at the edges of what the interface accepts: rotations off unit length, lengths from
// denormal to huge, and vertices put where a bound is attained.
#pragma once

#include <random>
#include <string>

#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace proptests::gen {

// Says how long quaternions are, whose squared length may be off by 1e-6.
enum class UnitLength { as_doubles, as_floats, anything, longest, shortest };
UnitLength random_unit_length(std::mt19937& random);
refitlab::Quaternion<double> with_length(const refitlab::Quaternion<double>& unit, UnitLength length, std::mt19937& random);
refitlab::Pose with_lengths(refitlab::Pose pose, UnitLength length, std::mt19937& random);

// Draws a placement with any rotation, any accepted length of its quaternion, and a translation of about this length, or none.
refitlab::RigidTransform<double> accepted_placement(std::mt19937& random, double far);

inline constexpr refitlab::Skinning all_skinnings[] = {refitlab::Skinning::linear, refitlab::Skinning::spherical,
                                                       refitlab::Skinning::hejl, refitlab::Skinning::dual_quaternion};
refitlab::Skinning drawn_skinning();  // within a property
refitlab::Skinning random_skinning(std::mt19937& random);

// Holds a corner on each side of a center along each axis, all equally far from it, and joints that all turn alike about it. So
// the vertices are the extreme points of any bound that knows a ball around them. Turns are half turns about the axes, where a
// quaternion that is too long stretches most, or any.
struct Attained {
  refitlab::SkinnedMesh mesh;  // an octahedron
  refitlab::Pose pose;
  refitlab::RigidTransform<double> placement;
  // This is more than the lengths that bounds are made from: about center, radius, joints' translations.
  double size;
  std::string what;
};
struct AttainedOptions {
  double unit = 1;  // of all lengths
  double far = 0;   // how far the placement moves, in the same units
  // 0 stands for any of 1 to 90.
  int joints = 0;
};
Attained attained(std::mt19937& random, const AttainedOptions& options = {});

// Makes a single triangle of joints that do not move, from its tip at the origin along an axis to the given side. Moved so that
// the tip is the farthest vertex of a body along that axis, it touches the body in that very double and nowhere else.
refitlab::SkinnedMesh needle(int axis, int sign, double length, int joints);

}  // namespace proptests::gen
