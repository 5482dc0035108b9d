// SPDX-License-Identifier: GPL-3.0-or-later
// Draws lists of rational balls for volumes to be put around, and points of their convex hull.
#pragma once

#include "lemmas/vocabulary/sphere.hpp"
#include "proptests/gen/vector.hpp"

namespace proptests::gen {

using RationalBalls = std::vector<refitlab::Ball3<Rational>>;

struct BallList {
  RationalBalls balls;
  // It has no radii, or centers that are equal, on a line, in a plane, on a sphere or a grid.
  bool is_degenerate;
};

// Draws 1 to most balls, all of radius 0, of one radius, or of any.
rc::Gen<BallList> ball_list(int most = 8);

// Draws a convex combination of points of the balls, often of their surfaces and often of one ball alone. It is to be called
// inside a property.
RationalVec<3> hull_point(const RationalBalls& balls);

void showValue(const BallList& list, std::ostream& out);

}  // namespace proptests::gen
