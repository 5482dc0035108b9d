// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational points of the unit sphere's surface in R^d, by inverse stereographic projection, and rational frames.
#pragma once

#include "proptests/gen/vector.hpp"

namespace proptests::gen {

// Maps y in R^(d-1) to ((1 - |y|^2), 2 y) / (1 + |y|^2), which reaches every rational point of the surface but (-1, 0, ..., 0).
template <int D>
RationalVec<D> inverse_stereographic(const std::vector<Rational>& y) {
  Rational square(0);
  for (int i = 0; i + 1 < D; ++i) square += y[i] * y[i];
  RationalVec<D> x;
  x[0] = (Rational(1) - square) / (Rational(1) + square);
  for (int i = 0; i + 1 < D; ++i) x[i + 1] = Rational(2) * y[i] / (Rational(1) + square);
  return x;
}

// Draws a point. The points +-e_i come up often; shrinks towards (1, 0, ..., 0).
template <int D>
rc::Gen<RationalVec<D>> sphere_point();

// Draws between low and high points, of which some are equal. In a fifth of the lists two are antipodal.
template <int D>
rc::Gen<std::vector<RationalVec<D>>> sphere_points(int low, int high);

// Holds two perpendicular unit vectors of R^d, d >= 2: an apex and a direction along the rim of its cap, say.
template <int D>
struct PerpendicularPair {
  RationalVec<D> first, second;
};
template <int D>
rc::Gen<PerpendicularPair<D>> perpendicular_pair();

template <int D>
void showValue(const PerpendicularPair<D>& pair, std::ostream& out) {
  rc::show(pair.first, out);
  out << " perpendicular to ";
  rc::show(pair.second, out);
}

}  // namespace proptests::gen
