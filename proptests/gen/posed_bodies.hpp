// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies of a few triangles, most of them in special positions: they share corners, edges and planes, are the same, or flat.
#pragma once

#include <random>

#include "algorithms/certificate/posed_body.hpp"

namespace proptests::gen {

enum class BodiesKind {
  anywhere,   // corners are any doubles
  on_a_grid,  // corners are small whole numbers: triangles share corners and edges, and some are flat
  in_a_plane,
  on_a_line,
  same,     // the second is the first, with its triangles in another order
  moved,    // the same, moved by a step of the grid or by the least there is
  touching  // corners of the second are on triangles of the first, up to rounding
};
inline constexpr int bodies_kind_count = 7;

struct TwoBodies {
  BodiesKind kind;
  refitlab::PosedBody first, second;
};

// Of up to 30 triangles, most often of at most 8. Some are in units from 2^-1074 to 2^1020.
TwoBodies two_bodies(std::mt19937& random);  // of any kind
TwoBodies two_bodies(std::mt19937& random, BodiesKind kind);

inline bool is_degenerate(const TwoBodies& bodies) { return bodies.kind != BodiesKind::anywhere; }

}  // namespace proptests::gen
