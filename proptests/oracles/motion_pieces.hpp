// SPDX-License-Identifier: GPL-3.0-or-later
// Makes motion pieces of one joint-set each, as they are before any are merged.
#pragma once

#include <numeric>

#include "algorithms/runtime/collide/motion_piece.hpp"
#include "algorithms/runtime/collide/simplex_pieces.hpp"

namespace proptests::oracle {

inline std::vector<refitlab::MotionPiece> motion_pieces(const refitlab::Character& c, std::span<const std::vector<int>> lists) {
  std::vector<refitlab::MotionPiece> out;
  for (std::size_t list = 0; list < lists.size(); ++list)
    for (const auto& [set, vertices] : refitlab::by_joint_set(c.sets, lists[list])) {
      out.push_back(refitlab::motion_piece(c, set, vertices));
      out.back().target = static_cast<int>(list);
    }
  return out;
}

// Returns the vertices of nodes of the sphere tree, or those of each.
inline std::vector<std::vector<int>> vertices_of_nodes(const refitlab::Character& c, const std::vector<int>& nodes) {
  std::vector<std::vector<int>> out;
  for (const int n : nodes) out.emplace_back(c.vertices[n].begin(), c.vertices[n].end());
  return out;
}
inline std::vector<std::vector<int>> vertices_of_nodes(const refitlab::Character& c) {
  std::vector<int> all(c.tree.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  return vertices_of_nodes(c, all);
}

}  // namespace proptests::oracle
