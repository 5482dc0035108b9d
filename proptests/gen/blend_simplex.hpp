// SPDX-License-Identifier: GPL-3.0-or-later
// Draws simplices of blends in exact rationals: what is linear in the weights at each weight vertex, with weights, made to be
// awkward.
#pragma once

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/weights.hpp"

namespace proptests::gen {

enum class Spread {
  // There are also equal and opposite weight vertices, weight vertices that are 0, and right angles.
  any,
  positive  // all (q'_k, q'_l) > 0
};

struct BlendCase {
  refitlab::SphericalBlend<Rational> blend;
  std::vector<Rational> weights;  // u of W_m
  // It is so for one weight vertex, equal weight vertices, a right angle, a weight vertex that is 0, and x = 0.
  bool is_degenerate() const;
};

// Draws 1 to most weight vertices of any length (blends of unit quaternions).
rc::Gen<BlendCase> blend_case(Spread spread, int most);

// Draws weights of sum 1 with any signs.
rc::Gen<std::vector<Rational>> affine_weights(int n);

void showValue(const BlendCase& c, std::ostream& out);

}  // namespace proptests::gen
