// SPDX-License-Identifier: MIT
// MotionPieces are what the motion bounds of nodes take one by one.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// These are the weights of some vertices, as far as a motion bound knows them (b7_motion_bound).
struct PieceWeights {
  std::vector<double> least;  // of each joint of a joint-set
  double products;            // the greatest sum of the products of two weights
  double squared_products;    // the greatest sum of their squares
};

struct MotionPiece {
  int joint_set;            // it has the joints of all vertices
  Ball3<double> reference;  // around the vertices in the reference pose; its numbers are floats
  Box<double> box;          // likewise around them, but its numbers are doubles
  double to_prior;          // the greatest distance from the ball's center to the prior of a vertex' rotation center
  int target;               // the node's position in a list
  PieceWeights weights;     // of the vertices
};

// Returns the piece of some vertices. There is one at least. joint_set has the joints of all. The target is 0.
MotionPiece motion_piece(const Character& character, int joint_set, std::span<const int> vertices);

}  // namespace refitlab
