// SPDX-License-Identifier: MIT
// PaletteRounding bounds the rounding errors of everything that is computed with a joint-set's blends.
//
// The true values are those of exact arithmetic on the numbers of the node and of the palette as they are given. So the
// given quaternions are of unit length only nearly, and the given rotation centers, their images and the dual parts are
// rounded already. The weights are multiples of 2^-24, so weight vertices have no error. Let u be half of epsilon, n the
// number of joints, and kappa >= 1 / ||q|| for all blends q = sum w_i q_i. Let T and t bound the lengths of the C_j r_c and
// the t_j (PaletteScales), and let x = p - r_c. Errors are vectors, in units of u, to first order. The scales are rounded up by
// 128 u, which leaves room for the terms in u^2.
//
// A blend of n terms has an error of n, relative to the largest length of its terms. What such an error of a quaternion turns
// and moves, b8_blend_error says: 2 kappa e ||x|| for an error of e.
//
// A vertex under spherical blending: the formula for a given blend loses 25 of ||x||, with the error of x, and 1 of T. The blend
// adds 2 n kappa, and n T.
//
// A control ball: after h <= 4 halvings the quaternions and centers at the weight vertices have an error of n + h. The hull
// of the control points of these computed values holds the blends of the computed values, so the errors count once: 2 (n +
// h) kappa ||x|| + (n + h) T. A control point is N / D. Near weight vertices (control_hull.hpp) have ||q'_k|| ||q'_l|| < 2
// W_kl, so the products P are at most 2 D ||x||, and the moved centers at most D T. With the error of x that is 80 and 29 + n +
// h. A cap: unit quaternions have an error of n kappa + 5, and the apex has 5. Half of that is the error of the chord s, with 4 s
// for its own rounding. As the image's angle is 4 arcsin s, and no more than a right angle, its error is at most 2.17 times that.
// With the ratios, the rotation and sums it is less than 80 + 2.25 (n + h) kappa, which covers both, and n + h + 1.
//
// Linear blending of a point p: the formula loses 15 of ||p|| and 1 of t (the given quaternions have no error), and the blend
// adds n of both. But R_j is not quite a rotation: with ||q||^2 = 1 + e the unit formula makes (1 + e) R - e, which stretches r
// by at most 2 |e| r.
//
// Linear blending by affine joints: let F bound the Frobenius norms of their matrices, and t the lengths of their offsets. The
// image of p is three products and their sum with the offset: 3 F ||p||, and one of F ||p|| + t. The blend adds n of both. The
// factor that r is stretched by has the squares of a1_affine_image. The blended matrix is off by n F. The root of the greatest
// row sum of its A^T A, which is at least F / sqrt 3, and the product have errors of 9 F. A factor that is blended of the joints'
// is at most 1.2 F, and off by n of that. Products of tiny numbers underflow, for which least_matrix stands.
//
// Dual quaternions: 2 ||d_j|| <= t, so that translations are at most kappa t. For a given blend the formula loses 23 of ||p|| and
// 13 of translations; q and d are off by n of their lengths. For a control ball, near weight vertices have ||q'_k|| ||q'_l|| <
// sqrt 2 W_kl. The quotient N / W has an error of 46, and 27 of translations. The weight vertices are off by n + 4 of both
// lengths. Beyond a right angle the ball of b6_dual_quaternion_ball accounts for its own rounding (refit_dual_quaternion.hpp).
//
// proptests/algorithms/control_budgets.cpp derives the constants of control balls and of affine joints from the refits' own
// templates, and bound_budgets.cpp those of vertices. palette_rounding.cpp there compares them with running errors.
//
// Skinning in double has the error of a vertex, with ||x|| + r in place of ||x||. The certified ball encloses these
// vertices too. A piece that is one vertex is computed exactly as skinning computes it, to the last bit, so it counts this
// error once.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <type_traits>

#include "lemmas/a1_affine_image.hpp"
#include "lemmas/b8_blend_error.hpp"
#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/vocabulary/nonzero.hpp"
#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

// PaletteScales are the scales of a joint-set in one pose, in float or double. Each is rounded up by far more than its own
// rounding error.
template <class S>
struct PaletteScales {
  S joints;         // n
  S center_image;   // T, the longest C_j r_c
  S translation;    // t, at least (1 + unit_defect) ||t_j||
  S inverse_blend;  // kappa: at least (1 + unit_defect) / ||sum w_i q_i|| for all convex weights, and for blends as computed
  S unit_defect;    // the greatest | ||q_j||^2 - 1 |
  S matrix;         // F of affine joints, to which the scales of rotations do not apply
};

// Returns the factor by which affine joints stretch. It is s of a1_affine_image, rounded up.
template <class S>
S stretch_of(const AffineMap<S>& map) {
  if constexpr (std::is_floating_point_v<S>)
    return root(squared_stretch(map)) * (S(1) + S(64) * std::numeric_limits<S>::epsilon());
  else return root(squared_stretch(map));
}

// Returns the least squared length of convex blends of the quaternions by c3_normalized_motion (iii). Let d be the least ||q_i||^2,
// and c the least (q_i, q_j) of all pairs, or d if that is less. transforms is not empty.
template <class S, std::size_t count>
S least_squared_blend(std::span<const RigidTransform<S>, count> transforms) {
  S shortest = squared_norm(transforms[0].rotation), cosine = shortest;
  for (std::size_t j = 1; j < transforms.size(); ++j) {
    shortest = min_of(shortest, squared_norm(transforms[j].rotation));
    for (std::size_t i = 0; i < j; ++i) cosine = min_of(cosine, dot(transforms[i].rotation, transforms[j].rotation));
  }
  return least_squared_blend(min_of(cosine, shortest), S(static_cast<int>(transforms.size())), shortest);
}

// Measures the scales. transforms is not empty.
// kappa is no greater than for a squared length of half of least_squared_length. Blends at weight vertices are no shorter than
// least_squared_length says. Between such that are 60 degrees apart at most, and in caps of up to 45 degrees, they are shorter by
// sqrt(1/2) at most.
template <class S>
PaletteScales<S> measure_palette(std::span<const RigidTransform<S>> transforms, std::span<const Vec<S, 3>> center_images) {
  static_assert(std::is_floating_point_v<S>);
  constexpr S up = S(1) + S(64) * std::numeric_limits<S>::epsilon(), rounding = S(64) * std::numeric_limits<S>::epsilon();
  S image(0), translation(0), defect(0);
  for (const RigidTransform<S>& t : transforms) {
    translation = max_of(translation, squared_norm(t.translation));
    defect = max_of(defect, absolute<S>(squared_norm(t.rotation) - S(1)));
  }
  for (const Vec<S, 3>& c : center_images) image = max_of(image, squared_norm(c));
  const S n(static_cast<double>(transforms.size()));
  const S squared_blend = max_of(S(least_squared_blend(transforms) - rounding), S(least_squared_length<S>() / 2));
  // Quaternions are no longer than 1 + defect, and computed blends shorter by n u at most.
  const S off = defect + rounding,
          longer = (S(1) + off) * (S(1) + n * S(std::numeric_limits<S>::epsilon()) / root(squared_blend));
  return {n, root(image) * up, root(translation) * up * (S(1) + off), up * longer / root(squared_blend), off, S(0)};
}

template <class S>
inline constexpr S least_matrix = S(std::is_same_v<S, double> ? 1e-130 : 1e-12);

// Measures the scales of affine joints, in float or double.
template <class S>
PaletteScales<S> measure_affine_palette(std::span<const AffineMap<S>> maps) {
  static_assert(std::is_floating_point_v<S>);
  constexpr S up = S(1) + S(64) * std::numeric_limits<S>::epsilon();
  S translation(0), matrix(0);
  for (const AffineMap<S>& map : maps) {
    translation = max_of(translation, squared_norm(map.offset));
    matrix = max_of(matrix, S(squared_norm(map.columns[0]) + squared_norm(map.columns[1]) + squared_norm(map.columns[2])));
  }
  const S n(static_cast<double>(maps.size()));
  return {n, S(0), root(translation) * up, S(1), S(0), root(matrix) * up + least_matrix<S>};
}

// The errors of this joint-set are at most per_length (||x|| + r) + per_radius r + offset.
template <class S>
struct RoundingRates {
  S per_length, per_radius, offset;
};

// These are the rates for one kind of skinning.
template <class S>
struct PaletteRounding {
  RoundingRates<S> vertex;           // for a skinned vertex, and for a vertex that is a piece of its own
  RoundingRates<S> weight_vertices;  // for a piece's control balls, and for its skinned vertices
};

template <class S>
PaletteRounding<S> rounding_linear(const PaletteScales<S>& palette) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  const S n = palette.joints, t = palette.translation;
  const RoundingRates<S> vertex{u * (15 + n), S(0), u * (n + 1) * t};
  return {vertex, {2 * vertex.per_length, error_of_rotate(palette.unit_defect), 2 * vertex.offset}};
}
template <class S>
PaletteRounding<S> rounding_affine(const PaletteScales<S>& palette) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  const S n = palette.joints, f = palette.matrix, t = palette.translation;
  const RoundingRates<S> vertex{u * (4 + n) * f, S(0), u * (n + 1) * t};
  return {vertex, {2 * vertex.per_length, u * (9 + S(1.25) * n) * f, 2 * vertex.offset}};
}
template <class S>
PaletteRounding<S> rounding_spherical(const PaletteScales<S>& palette) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  constexpr S turned(25), control(80), centers(33);  // the latter two also of caps
  const S n = palette.joints, kappa = palette.inverse_blend, t = palette.center_image;
  const RoundingRates<S> vertex{u * (turned + turn_of_error(n, kappa)), S(0), u * (n + 1) * t};
  return {vertex, {vertex.per_length + u * (control + S(2.25) * (n + 4) * kappa), S(0), vertex.offset + u * (centers + n) * t}};
}
template <class S>
PaletteRounding<S> rounding_dual_quaternion(const PaletteScales<S>& palette) {
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  constexpr S turned(23), moved(13), control(46), translations(27);
  const S n = palette.joints, kappa = palette.inverse_blend, t = palette.translation * kappa;
  const auto move = [&](const S& error) {
    const S dual = palette.translation / 2;
    return move_of_error<S>({error, error * dual, dual, kappa});
  };
  const RoundingRates<S> vertex{u * (turned + turn_of_error(n, kappa)), S(0), u * (moved * t + move(n))};
  const S halved = n + 4;  // of weight vertices
  return {vertex,
          {vertex.per_length + u * (control + turn_of_error(halved, kappa)), S(0),
           vertex.offset + u * (translations * t + move(halved))}};
}

// The rates are by kind of skinning: linear, spherical (also for Hejl's), dual quaternion.
template <class S>
using PaletteRoundings = std::array<PaletteRounding<S>, 3>;

template <class S>
PaletteRoundings<S> roundings_of(const PaletteScales<S>& palette) {
  return {rounding_linear(palette), rounding_spherical(palette), rounding_dual_quaternion(palette)};
}
// Affine joints have no rates but those of linear skinning.
template <class S>
PaletteRoundings<S> affine_roundings_of(const PaletteScales<S>& palette) {
  constexpr S unknown = std::numeric_limits<S>::infinity();
  constexpr PaletteRounding<S> none{{unknown, unknown, unknown}, {unknown, unknown, unknown}};
  return {rounding_affine(palette), none, none};
}

}  // namespace refitlab
