// SPDX-License-Identifier: MIT
// These are the pieces of nodes for the fast queries. A piece is the part of a node in one joint-set, and is bounded by itself.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

struct SimplexPiece {
  int joint_set;
  Ball3<double> reference;  // around its vertices in the reference pose; its numbers are floats
  Box<double> box;          // likewise around them, but its numbers are doubles
  std::vector<double> low;  // the least weights of its joints
  double rest;              // 1 - sum low, at least 0
  int target;               // the node's position in a list
};

// Returns a ball around the points. Its numbers are floats.
Ball3<double> float_ball(const std::vector<Point3>& points);

// Returns the vertices of each joint-set, by its number, in the order of the list.
std::map<int, std::vector<int>> by_joint_set(const JointSets& sets, std::span<const int> vertices);

// Returns the pieces of the vertices in each list. The list's position is the target of its pieces. No list may be empty.
std::vector<SimplexPiece> pieces_of_vertices(const Character& character, std::span<const std::vector<int>> lists);
std::vector<SimplexPiece> pieces_of_nodes(const Character& character, std::span<const int> nodes);

}  // namespace refitlab
