// SPDX-License-Identifier: MIT
// FloatPaletteEntry is the palette of a joint-set in one pose and placement, for spherical skinning in float. It bounds the error
// of that against the doubles of apply(placement, skin()).
//
// A joint-set has a middle m in the reference frame, near its vertices. Each vertex v is stored as the floats of p = v - m,
// and its weights are floats already, because they are multiples of 2^-24. Coordinates are those of the world, seen from an
// origin near the body. Let P be the placement and r_c the rotation center. Everything is computed in double first, from the
// same r_c and the same C_j r_c as make_skinning_palette finds, and then rounded: r = r_c - m, the products of P's quaternion
// and the q_j, and the placed C_j r_c, of which all but the first are stored as differences to the first. The kernel blends
//   q = q_0 + sum w_j (q_j - q_0), c = c_0 + sum w_j (c_j - c_0),
// and with x = p - r the image is x + s (w t + v x t) + c, where (w, v) = q, t = v x x and s = 2 / ||q||^2.
//
// Slack. Let u = 2^-24 and n be the number of joints. Let X bound |p| + |r|, and so |x|, and let T bound the placed C_j r_c.
// kappa is as in palette_rounding.hpp. Errors are lengths of vectors, in units of u, to first order.
//   x: p, r and their difference are rounded, which is |p| + |r| + |x| <= 2 X.
//   q: q_0 has 1. Signs are consistent, so that |q_j - q_0| <= sqrt 2. The weights of the differences add up to less than 1,
//      so that rounding them has sqrt 2, and so have the products. Partial sums are convex combinations of the q_j, so that
//      n - 1 sums have one each. Together that is below n + 3, which turns x by at most 2 kappa (n + 3) X (b8_blend_error).
//   t: a cross product has sqrt 2 |v| |x| of products and |v| |x| of differences, which is 2.42 |v| |x|. v x t has this twice.
//      w t has it and one more. Their sum is |w t + v x t| <= |v| ||q|| |x|, and it is rounded. With |v| = ||q|| sin a and w =
//      ||q|| cos a that is (4.84 sin^2 a + 3.42 sin a cos a + sin a) ||q||^2 |x|, which is below 6.4 ||q||^2 |x|. s doubles
//      this and divides it by ||q||^2: 12.8 X.
//   s: ||q||^2 has 5 and the quotient 1, and the product with s has 1. s (w t + v x t) is at most 2 |x|: 14 X.
//   c: c_0 has T, and the differences, which are at most 2 T, have 2 T for each of their roundings, which is rounding them and
//      their products. n - 1 sums have T each. That is (n + 4) T.
//   Sums: x + c and the result are rounded, and each is at most X + T.
// Together that is (31 + 2 kappa (n + 3)) X + (n + 6) T. The entry counts 32 and n + 7 and a share of 2^-10 of all for terms
// in u^2 and for the doubles, whose own errors are 2^-29 of these. Products and sums that are fused (.ci/kernels.cmake) lose
// less. least_float_slack is more than products can lose by underflow.
//   One joint: the blend is a matrix M, and the image is M p + (c - M r). M has sqrt 3 |p|, p has |p|, products and sums have
//   4 sqrt 3 |p| and 4 of the offset, which is at most X + T and is rounded itself: together below 10 X + 5 T.
//
// P turns with the formula for unit quaternions. If ||q_P||^2 = 1 + e, this stretches by at most 2 |e|, of which the float
// image of x knows nothing: 2 |e| X. (C_j r_c are turned as they are.) And the world's doubles are rounded, which depends on
// how far the body and the origin are from the world's: FloatPlacement::lost.
//
// Hypotheses that are checked for each entry: kappa <= 3/2, by the bound of measure_palette; at most most_palette_joints joints;
// and X + T <= largest_float_length, so that products of three lengths do not overflow. Otherwise slack is infinite, and the
// entry must not be used. proptests/algorithms/float_budgets.cpp derives the counts from the kernel.
#pragma once

#include "lemmas/b8_blend_error.hpp"

namespace refitlab {

inline constexpr double largest_float_length = 1e12, least_float_slack = 1e-37, largest_float_kappa = 1.5;
// The entry's slack in units of u is the first function times X plus the second times T, and a share of both is added.
constexpr double float_slack_per_length(int joints) {
  return joints == 1 ? 10 : 32 + turn_of_error<double>(joints + 3, largest_float_kappa);
}
constexpr double float_slack_per_image(int joints) { return joints == 1 ? 5 : joints + 7; }
inline constexpr double float_slack_and_more = 1 + 0x1p-10;

struct alignas(64) FloatPaletteEntry {
  float center[3];  // r
  float slack;      // of each coordinate of an image
  float first[8];   // the placed q_0, c_0, and an unused number
  // These are the differences of the other joints to the first one. For a joint-set of one joint there is a 3 x 4 matrix instead,
  // row by row.
  float more[3][8];
  float unused[12];
};

// A FloatPlacement puts a body in the world. Its translation is seen from the origin.
struct FloatPlacement {
  double rotation[4], translation[3];
  double defect;  // | ||q||^2 - 1 |
  double lost;    // of each coordinate in the world, in double
};

}  // namespace refitlab
