// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of moving vertices that hold at every time of an animation, or at all times and weights of a crossfade: slabs in given
// directions, and a ball.
//
// The bound of a cell of parameters is that of its corners, blown up by what a vertex may be off what lies between them
// (c6_interval_hull). The cell that reaches farthest beyond what vertices are seen to reach is halved, which quarters the slack,
// until none does by more than the tolerance: so most of the time is looked at key by key, and only the extremes closer.
#pragma once

#include <span>

#include "algorithms/bake/over_time/moving_vertices.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "lemmas/c6_interval_hull.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

struct OverTimeOptions {
  // How much larger than needed a bound may be: the volume of a box of the slabs along the axes, and that of the ball, as a
  // share. More than 0. Only what halving cells can change counts.
  double tolerance = 0.01;
  std::vector<Point3> directions = {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()};
  bool with_ball = true;
  // Of all cells together, for slabs and for the ball. What hardly has a size would be looked at for ever.
  std::size_t most_halvings = std::size_t(1) << 16;
};

// Vertices that are somewhere at the ends of an interval of time are within the slack of the chords between them (c1_chord_bound).
struct ProvenInterval {
  double start, end;  // seconds
  double slack;       // units of the file
};

struct BoundOverTime {
  std::vector<Slab<double>> slabs;  // by direction
  Ball3<double> ball;
  // What both are made of, of joints with one parameter: intervals that cover it, in order of time.
  std::vector<ProvenInterval> slab_intervals, ball_intervals;
  int moments = 0;  // at which the vertices were skinned
  double gap = 0;   // what slabs are wider than moments have seen, at most; units of the file
};

// However any of these joints can be, at least one. Throws std::invalid_argument for a tolerance that is not positive, and what
// MovingVertices::slack throws.
BoundOverTime bound_over_time(std::span<const MovingJoints* const> joints, const MovingVertices& vertices,
                              const OverTimeOptions& options = {});
BoundOverTime bound_over_time(const MovingJoints& joints, const MovingVertices& vertices, const OverTimeOptions& options = {});

// The box of slabs along x, y and z.
Box<double> box_of(std::span<const Slab<double>> slabs);

// The least box in float that encloses this one.
Box<float> rounded_outward(const Box<double>& box);

}  // namespace refitlab
