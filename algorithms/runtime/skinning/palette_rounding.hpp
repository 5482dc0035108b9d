// SPDX-License-Identifier: MIT
// PaletteRounding: how far rounding may carry what is computed with a joint-set's blends from what is true.
//
// Truth is exact arithmetic on the numbers of the node and of the palette as they stand: quaternions that are of unit length
// only nearly, rotation centers, their images and dual parts as they were rounded. The weights are multiples of 2^-24, so
// corners have no error. u is half of epsilon; n joints; kappa >= 1 / ||q|| for all blends q = sum w_i q_i; T and t bound
// the C_j r_c and the t_j (PaletteScales); x = p - r_c. Errors are vectors, in units of u, to first order; the constants are
// some tenths larger than what they are derived from, which leaves room for the terms in u^2.
//
// Elementary errors stand in namespace rounding below, relative to the lengths of the operands; a blend of n is off by n, of
// what its terms are at most; and a quaternion off by e in place of one of length 1/kappa or more turns x to a place off by at
// most 2 kappa e ||x||.
//
// A vertex under spherical blending: x is off by 1, the turned x by rotate_scaled, and by the squared length, its inverse and
// the product; 2 n kappa from the blend; the center's image by n T; the sum by 1 of both.
//
// A corner's ball. After h <= 4 halvings corners are off by n + h. The hull of control points of the corners as they are
// holds the blends of these, so the corners' own errors count once: 2 (n + h) kappa ||x|| + (n + h) T. A control point is
// N / D; near corners have ||q'_k|| ||q'_l|| < 2 W_kl, so the products P are at most 2 D ||x||, off by twice mix_numerator of
// D ||x|| in their sum and by 4 for adding; the moved centers, at most D T, by twice mix_weight and 3 for products and sums;
// adding both: 2 and 1; D by twice mix_weight and 2, its inverse and the product by one each, of at most 2 ||x|| + T.
// With the error of x that is 93 and 32 + n + h, and 2 (n + h) kappa.
// A cap: unit quaternions are off by n kappa + 5, the apex by 5; half of that is the chord s's error, with 3 s for its own
// rounding, and as the image's angle is 4 arcsin s and s^2 < 1/2, the angle's is 4 sqrt 2 times as much: 41 + 2.9 n kappa;
// the ratios and ||x|| 10; the rotation 24 and, for an apex off unit length, 20; sums 2: that is 97 + 2.9 n kappa, and n + 5.
// One formula for both: (100 + 3 (n + 4) kappa) ||x|| + (36 + n) T.
//
// Linear blending of a point p: rotate (its quaternions are what they are), the sum 1, the blend n of both. But R_j is not
// quite a rotation: with ||q||^2 = 1 + e the unit formula makes (1 + e) R - e, which stretches r by at most 2 |e| r.
//
// Dual quaternions: as spherical with p for x, and with 2 ||d_j|| <= t, translations of at most kappa t. A vertex: as a
// spherical one, and Im(d q*) off by 7, doubled, 1 for the sum, squared length and quotient, n for d, n kappa for q. A corner:
// near ones have ||q'_k|| ||q'_l|| < sqrt 2 W_kl; the numerator sqrt 2 mix_numerator, sums 2, the quotient 11; T_kl 7 and 7, and
// 3 for sums, times sqrt 2, the quotient 11; corners 2 (n + 4) kappa of each. Beyond a right angle the ball of
// b6_dual_quaternion_ball rounds itself (dual_quaternion.hpp).
//
// Skinning in double is off as a vertex is, ||x|| + r in place of ||x||. The certified ball encloses its vertices too; pieces
// that are a vertex are skinned as it is, to the last bit, and pay once.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include "lemmas/vocabulary/nonzero.hpp"
#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

// Of what the operations are off by, in u and relative to the lengths of vectors and quaternions: proptests/gappa has a proof
// of each, by component and at unit length, and proptests/algorithms/palette_rounding.cpp compares them with running errors.
namespace rounding {
inline constexpr int squared_length = 5;  // of a quaternion
inline constexpr int rotate = 24;         // by a quaternion taken to be of unit length
inline constexpr int rotate_scaled = 24;
inline constexpr int mix_weight = 6, mix_numerator = 27;  // mix_rotations
}  // namespace rounding

// Of a joint-set in one pose, in float or double, each rounded up by far more than its own rounding.
template <class S>
struct PaletteScales {
  S joints;         // n
  S center_image;   // T, the longest C_j r_c
  S translation;    // t, the longest t_j
  S inverse_blend;  // kappa: at least 1 / ||sum w_i q_i|| for all convex weights, but at most 1 / sqrt(least_squared_length)
  S unit_defect;    // the greatest | ||q_j||^2 - 1 |
};

// With d the least ||q_i||^2 and c the least (q_i, q_j) of all pairs, or d if that is less,
//   ||sum w_i q_i||^2 >= d sum w_i^2 + c (1 - sum w_i^2) >= c + (d - c) / n.
template <class S>
PaletteScales<S> measure_palette(std::span<const RigidTransform<S>> transforms, std::span<const Vec<S, 3>> center_images) {
  static_assert(std::is_floating_point_v<S>);
  constexpr S up = S(1) + S(64) * std::numeric_limits<S>::epsilon(), rounding = S(64) * std::numeric_limits<S>::epsilon();
  S image(0), translation(0), defect(0), shortest = std::numeric_limits<S>::infinity(), dot_product = shortest;
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const Quaternion<S>& q = transforms[i].rotation;
    const S squared_length = squared_norm(q);
    translation = max_of(translation, squared_norm(transforms[i].translation));
    defect = max_of(defect, S(std::abs(squared_length - S(1))));
    shortest = min_of(shortest, squared_length);
    for (std::size_t j = 0; j < i; ++j) dot_product = min_of(dot_product, dot(q, transforms[j].rotation));
  }
  for (const Vec<S, 3>& c : center_images) image = max_of(image, squared_norm(c));
  dot_product = min_of(dot_product, shortest);
  const S n(static_cast<double>(transforms.size()));
  const S squared_blend = max_of(S(dot_product + (shortest - dot_product) / n - rounding), S(least_squared_length<S>()));
  return {n, root(image) * up, root(translation) * up, up / root(squared_blend), defect + rounding};
}

// Errors of this joint-set are at most per_length (||x|| + r) + per_radius r + offset.
template <class S>
struct RoundingRates {
  S per_length, per_radius, offset;
};

// Of one kind of skinning.
template <class S>
struct PaletteRounding {
  RoundingRates<S> vertex;   // as skinned, and as a piece of its own
  RoundingRates<S> corners;  // of a piece's control balls, and of its skinned vertices
};

template <class S>
PaletteRounding<S> rounding_linear(const PaletteScales<S>& palette) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  const S n = palette.joints, t = palette.translation;
  const RoundingRates<S> vertex{u * (S(rounding::rotate + 1) + n), S(0), u * (n + 1) * t};
  return {vertex, {2 * vertex.per_length, 2 * palette.unit_defect, 2 * vertex.offset}};
}
template <class S>
PaletteRounding<S> rounding_spherical(const PaletteScales<S>& palette) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  constexpr S turned(1 + rounding::rotate_scaled + (rounding::squared_length + 2) + 1);
  constexpr S cap(100), control(1 + 2 * rounding::mix_numerator + 4 + 2 + 2 * (2 * rounding::mix_weight + 2 + 2));
  constexpr S centers(4 * rounding::mix_weight + 2 + 2 + 3 + 1 + 4);
  static_assert(control <= cap);
  const S n = palette.joints, kappa = palette.inverse_blend, t = palette.center_image;
  const RoundingRates<S> vertex{u * (turned + 2 * n * kappa), S(0), u * (n + 1) * t};
  return {vertex, {vertex.per_length + u * (cap + 3 * (n + 4) * kappa), S(0), vertex.offset + u * (centers + n) * t}};
}
template <class S>
PaletteRounding<S> rounding_dual_quaternion(const PaletteScales<S>& palette) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  constexpr S turned(rounding::rotate_scaled + (rounding::squared_length + 1) + 1);
  constexpr S moved(2 * 7 + 1 + (rounding::squared_length + 1) + 1);
  constexpr S control(1.42 * rounding::mix_numerator + 2 + 11 + 1), translations(1.42 * 17 + 2 + 11 + 1);
  const S n = palette.joints, kappa = palette.inverse_blend, t = palette.translation * palette.inverse_blend;
  const RoundingRates<S> vertex{u * (turned + 2 * n * kappa), S(0), u * (moved + 2 * n * kappa) * t};
  return {vertex,
          {vertex.per_length + u * (control + 2 * (n + 4) * kappa), S(0),
           vertex.offset + u * (translations + 2 * (n + 4) * kappa) * t}};
}

// By kind of skinning: linear, spherical (Hejl's too), by dual quaternions.
template <class S>
using PaletteRoundings = std::array<PaletteRounding<S>, 3>;

template <class S>
PaletteRoundings<S> roundings_of(const PaletteScales<S>& palette) {
  return {rounding_linear(palette), rounding_spherical(palette), rounding_dual_quaternion(palette)};
}

}  // namespace refitlab
