// SPDX-License-Identifier: GPL-3.0-or-later
// Returns the scales of a palette as they are measured: rounded up, which leaves room for terms of higher order.
#pragma once

#include "algorithms/runtime/skinning/palette_rounding.hpp"
#include "proptests/oracles/norm_budget.hpp"

namespace proptests::oracle {

inline refitlab::PaletteScales<double> rounded_scales(int joints, double kappa, double image, double translation,
                                                      double matrix = 0) {
  constexpr double up = 1 + 128 * Budget::u;  // measure_palette, in float
  return {double(joints), image * up, translation * up, kappa * up, 0, matrix * up};
}

}  // namespace proptests::oracle
