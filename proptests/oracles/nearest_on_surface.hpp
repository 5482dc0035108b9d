// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the point of a sphere's surface in a given direction from its center, with exact roots: a slow and obvious way to see
// whether a half-space or a ball meets the surface.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace proptests {

// Returns the point. The direction must not be 0.
template <int D>
refitlab::Vec<refitlab::ExactRoot, D> point_towards(const refitlab::SquaredBall<refitlab::ExactRoot, D>& surface,
                                                    const refitlab::Vec<refitlab::ExactRoot, D>& direction) {
  const refitlab::ExactRoot stretch = refitlab::root(surface.squared_radius) / refitlab::norm(direction);
  return surface.center + direction * stretch;
}

}  // namespace proptests
