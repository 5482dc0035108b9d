// SPDX-License-Identifier: MIT
// MotionPieces are what the motion bounds of nodes take one by one.
#pragma once

#include "algorithms/runtime/balls/box.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

struct MotionPiece {
  int joint_set;            // it has the joints of all vertices
  Ball3<double> reference;  // around the vertices in the reference pose; its numbers are floats
  Box<double> box;          // likewise around them, but its numbers are doubles
  double to_prior;          // the greatest distance from the ball's center to the prior of a vertex' rotation center
  int target;               // the node's position in a list
};

}  // namespace refitlab
