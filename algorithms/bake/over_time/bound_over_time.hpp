// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of moving vertices that hold at every time of an animation: slabs in given directions, and a ball.
//
// The bound of an interval is that of its ends, blown up by what a vertex may be off its chord (c6_interval_hull). Intervals
// that reach beyond all others by more than the tolerance are halved, which quarters the slack: so most of the time is
// looked at key by key, and only the extremes closer.
#pragma once

#include "algorithms/bake/over_time/moving_vertices.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "lemmas/c6_interval_hull.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

struct OverTimeOptions {
  // How much larger than needed a bound may be: the volume of a box of the slabs along the axes, and that of the ball, as a
  // share. More than 0. Only what halving intervals can change counts.
  double tolerance = 0.01;
  std::vector<Point3> directions = {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()};
  bool with_ball = true;
};

struct BoundOverTime {
  std::vector<Slab<double>> slabs;  // by direction
  Ball3<double> ball;
  int moments = 0;  // at which the vertices were skinned
  double gap = 0;   // what slabs are wider than moments have seen, at most; units of the file
};

// At all times of the animation. Throws std::invalid_argument for a tolerance that is not positive, and what
// MovingVertices::slack throws.
BoundOverTime bound_over_time(const AnimatedJoints& joints, const MovingVertices& vertices, const OverTimeOptions& options = {});

// The box of slabs along x, y and z.
Box<double> box_of(std::span<const Slab<double>> slabs);

// The least box in float that encloses this one.
Box<float> rounded_outward(const Box<double>& box);

}  // namespace refitlab
