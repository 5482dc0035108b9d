// SPDX-License-Identifier: GPL-3.0-or-later
// These bounds of moving vertices hold at every time of an animation, or at all times and weights of a crossfade. They are slabs
// in given directions, and a ball.
//
// The bound of a cell of parameters is that of its corners, blown up by a slack, which is how far a vertex may be from the
// interpolation of the corners (c6_interval_hull). The cell whose bound reaches farthest beyond the vertices that were seen is
// halved, which quarters its slack, until no bound reaches farther than the tolerance. So most of the time is looked at key by
// key, and only the extremes closer.
#pragma once

#include <span>

#include "algorithms/bake/over_time/moving_vertices.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "lemmas/vocabulary/slab.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

struct OverTimeOptions {
  // A bound may be larger than needed by this share: in the volume of the box of the slabs along the axes, and in that of the
  // ball. It is more than 0. Only the excess that halving cells can change counts.
  double tolerance = 0.01;
  // There is at least one, and its length is from 1e-100 to 1e100.
  std::vector<Point3> directions = {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()};
  // This limits the halvings of all cells together, for slabs and for the ball. Without it, a set of vertices that hardly has a
  // size would be looked at for ever.
  std::size_t most_halvings = std::size_t(1) << 16;
};

// In such an interval, vertices are within the slack of the chords between their places at both ends (c1_chord_bound).
struct ProvenInterval {
  double start, end;  // seconds
  double slack;       // units of the file
};

struct BoundOverTime {
  std::vector<Slab<double>> slabs;  // by direction
  Ball3<double> ball;
  // For joints with one parameter, these are the intervals from which both bounds are made. They cover the parameter, in order of
  // time.
  std::vector<ProvenInterval> slab_intervals, ball_intervals;
  ErrorGrowth errors;  // at any time
  int moments = 0;     // at which the vertices were skinned
  double gap = 0;      // the most by which a slab is wider than the vertices that were seen at moments; units of the file
};

// Returns bounds that hold for all that any of these joints, at least one, can do. Throws std::invalid_argument for a tolerance
// that is not positive and for directions out of range, and what MovingVertices::slack throws.
BoundOverTime bound_over_time(std::span<const MovingJoints* const> joints, const MovingVertices& vertices,
                              const OverTimeOptions& options);
BoundOverTime bound_over_time(const MovingJoints& joints, const MovingVertices& vertices, const OverTimeOptions& options);

// Returns the box of slabs along x, y and z.
Box<double> box_of(std::span<const Slab<double>> slabs);

// Returns the least box in float that encloses this one.
Box<float> rounded_outward(const Box<double>& box);

}  // namespace refitlab
