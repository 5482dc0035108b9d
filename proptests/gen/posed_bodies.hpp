// SPDX-License-Identifier: GPL-3.0-or-later
// Draws two bodies of a few triangles, most of them in special positions: they share corners, edges and planes, are the same, or
// flat.
#pragma once

#include <random>

#include "algorithms/certificate/posed_body.hpp"

namespace proptests::gen {

enum class BodiesKind {
  // Corners are any doubles.
  anywhere,
  // Corners are small whole numbers: triangles share corners and edges, and some are flat.
  on_a_grid,
  in_a_plane,
  on_a_line,
  // The second is the first, with its triangles in another order.
  same,
  // The second is the first, moved by a step of the grid or by the least there is.
  moved,
  // Corners of the second are on triangles of the first, up to rounding.
  touching
};
inline constexpr int bodies_kind_count = 7;

struct TwoBodies {
  BodiesKind kind;
  refitlab::PosedBody first, second;
};

// Draws bodies of up to 30 triangles, most often of at most 8. Some are in units from 2^-1074 to 2^1020.
TwoBodies two_bodies(std::mt19937& random);  // of any kind
TwoBodies two_bodies(std::mt19937& random, BodiesKind kind);

inline bool is_degenerate(const TwoBodies& bodies) { return bodies.kind != BodiesKind::anywhere; }

}  // namespace proptests::gen
