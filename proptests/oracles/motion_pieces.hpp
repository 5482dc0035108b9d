// SPDX-License-Identifier: GPL-3.0-or-later
// Makes motion pieces of one joint-set each, as they are before any are merged.
#pragma once

#include "algorithms/runtime/collide/motion_piece.hpp"
#include "algorithms/runtime/collide/simplex_pieces.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace proptests::oracle {

inline std::vector<refitlab::MotionPiece> motion_pieces(const refitlab::Character& c,
                                                        const std::vector<refitlab::SimplexPiece>& pieces) {
  std::vector<refitlab::MotionPiece> out;
  for (const refitlab::SimplexPiece& p : pieces) {
    const refitlab::Point3 prior = refitlab::center_prior(c.mesh, c.sets.joints(p.joint_set), refitlab::Skinning::spherical);
    out.push_back({p.joint_set, p.reference, p.box, (p.reference.center - prior).norm(), p.target});
  }
  return out;
}

// Returns the vertices of each node of the sphere tree.
inline std::vector<std::vector<int>> vertices_of_nodes(const refitlab::Character& c) {
  std::vector<std::vector<int>> out;
  for (std::size_t n = 0; n < c.tree.nodes.size(); ++n) out.emplace_back(c.vertices[n].begin(), c.vertices[n].end());
  return out;
}

}  // namespace proptests::oracle
