// SPDX-License-Identifier: MIT
// Beyond the paper: what an affine map makes of a ball, a box, and the hull of balls: joints that scale and shear.
//
// Statement. Let C x = A x + b, and s^2 the greatest sum of absolute values in a row of A^T A. Then
// (i) C carries the ball about c of radius r into that about C c of radius s r. If the columns of A are at right angles, as those
//   of a rotation behind a scale along axes are, no smaller radius will do.
// (ii) C carries a box about c with the half extents e into that about C c with |A| e, and no smaller box about C c will do. A
//   slab {x : low <= (n, x) <= high} holds an image if and only if {x : low - (n, b) <= (A^T n, x) <= high - (n, b)} holds the
//   point. In the direction n the images of a ball are within ||A^T n|| r of C c, and reach that far.
// (iii) C carries a point within r of the hull of points p_k to within s r of the hull of the C p_k. So a control hull may be
//   carried.
// (iv) Linear blending by any affine C_i, v' = sum w_i C_i v, stays in any convex set that holds all C_i v.
// (v) Let C_c = sum c_i C_i be the blend at a weight vertex c, and let s_i be no less than the s of C_i. A vertex within r of p
//   whose weights are a convex combination of some c is in the hull of the balls about the C_c p of the radii s(c) r, where s(c)
//   is the s of C_c, or sum c_i s_i if that is less. So rigid joints leave r as it is, and a scale of all joints is exact.
//
// Replaces: section 3, where joints are rigid.
// Notation: A -> columns, b -> offset, s^2 -> squared_stretch, e -> half.
//
// Proof. ||A d||^2 = (d, A^T A d), and the greatest eigenvalue of a symmetric matrix is at most its greatest row sum; A^T A is
// diagonal if columns are at right angles. (ii) |(A d)_i| <= sum |A_ij| |d_j|, with equality at a corner; (n, C x) = (A^T n, x) +
// (n, b), and (n, A d) = (A^T n, d) is ||A^T n|| r for d along A^T n. (iii) C of a convex combination is that of the images, and
// C(p + d) = C p + A d. (iv) v' is a convex combination. (v) With w = sum u_k c_k, v' = sum u_k C_{c_k} v is a convex combination
// of images, of which that by c is within s(c) r of C_c p by (i): ||A_c d|| is also at most sum c_i ||A_i d||.
#pragma once

#include "lemmas/vocabulary/affine.hpp"
#include "lemmas/vocabulary/sphere.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// Returns s^2.
template <class S>
S squared_stretch(const AffineMap<S>& map) {
  S greatest(0);
  for (const auto& row : map.columns) {
    S sum(0);
    for (const auto& column : map.columns) sum = sum + absolute<S>(dot(row, column));
    greatest = max_of(greatest, sum);
  }
  return greatest;
}

// Returns the ball of (i) by its squared radius, so that it takes no root.
template <class S>
SquaredBall<S, 3> image_of_ball(const AffineMap<S>& map, const SquaredBall<S, 3>& ball) {
  return {apply(map, ball.center), squared_stretch(map) * ball.squared_radius};
}

// Returns the half extent along an axis of the image of a box with these half extents. row is that of A for the axis.
template <class S>
S image_half_extent(const Vec<S, 3>& row, const Vec<S, 3>& half) {
  return absolute<S>(row[0]) * half[0] + absolute<S>(row[1]) * half[1] + absolute<S>(row[2]) * half[2];
}

// A box is given by its center and its half extents.
template <class S>
struct HalfBox {
  Vec<S, 3> center, half;
};

// Returns the box of (ii).
template <class S>
HalfBox<S> image_of_box(const AffineMap<S>& map, const HalfBox<S>& box) {
  HalfBox<S> out{apply(map, box.center), box.half};
  for (int i = 0; i < 3; ++i)
    out.half[i] = image_half_extent<S>({map.columns[0][i], map.columns[1][i], map.columns[2][i]}, box.half);
  return out;
}

// Returns A^T n of (ii): a point is in a slab along it if and only if its image is in one along n.
template <class S>
Vec<S, 3> direction_before(const AffineMap<S>& map, const Vec<S, 3>& direction) {
  return {dot(map.columns[0], direction), dot(map.columns[1], direction), dot(map.columns[2], direction)};
}

// Returns ||A^T n|| of (ii), which is how far A takes the unit ball in the direction n.
template <class S>
S reach_along(const AffineMap<S>& map, const Vec<S, 3>& direction) {
  return norm(direction_before(map, direction));
}

// --- Hypotheses ---

template <class S>
Verdict encloses(const HalfBox<S>& box, const Vec<S, 3>& x) {
  Verdict v = Verdict::holds;
  for (int i = 0; i < 3; ++i) v &= less_equal(absolute<S>(x[i] - box.center[i]), box.half[i]);
  return v;
}

// The hypotheses of (iii) are that w is convex, and that beside is no longer than the radius. The point is beside plus the point
// of the hull that w gives.
template <class S>
Verdict is_near_points(std::span<const S> w, const Vec<S, 3>& beside, const S& squared_radius) {
  return is_convex(w) & less_equal(squared_norm(beside), squared_radius);
}

// --- Conclusion ---

// The witness is the image of the point and its offset from the center's image.
template <class S>
struct CarriedPoint {
  Verdict verdict;
  Vec<S, 3> image, beside;
};

// Checks the witness independently, row by row: beside is A d, and the image is the center's image plus beside.
template <class S>
Verdict is_carried(const AffineMap<S>& map, const SquaredBall<S, 3>& ball, const Vec<S, 3>& point,
                   const CarriedPoint<S>& witness) {
  Verdict v = less_equal(squared_norm(witness.beside), S(squared_stretch(map) * ball.squared_radius));
  for (int i = 0; i < 3; ++i) {
    S row(0), center = map.offset[i];
    for (int j = 0; j < 3; ++j) {
      row = row + map.columns[j][i] * (point[j] - ball.center[j]);
      center = center + map.columns[j][i] * ball.center[j];
    }
    v &= equal(witness.beside[i], row) & equal(witness.image[i], S(center + row));
  }
  return v;
}

template <class S>
CarriedPoint<S> ball_is_carried(const AffineMap<S>& map, const SquaredBall<S, 3>& ball, const Vec<S, 3>& point) {
  const Vec<S, 3> image = apply(map, point);
  return {encloses(image_of_ball(map, ball), image), image, image - apply(map, ball.center)};
}

template <class S>
Verdict box_is_carried(const AffineMap<S>& map, const HalfBox<S>& box, const Vec<S, 3>& point) {
  return encloses(image_of_box(map, box), apply(map, point));
}

// Judges (iii): the image of the point is within s r of the same combination of the images.
template <class S>
Verdict hull_is_carried(const AffineMap<S>& map, std::span<const Vec<S, 3>> points, std::span<const S> w, const Vec<S, 3>& beside,
                        const S& squared_radius) {
  Vec<S, 3> of_images = apply(map, points[0]) * w[0];
  for (std::size_t k = 1; k < w.size(); ++k) of_images = of_images + apply(map, points[k]) * w[k];
  const Vec<S, 3> image = apply<S>(map, combine<S, 3>(w, points) + beside);
  return less_equal(squared_distance(image, of_images), S(squared_stretch(map) * squared_radius));
}

// Returns the squared stretch of (v) for the weights w. No factor of stretches is less than its joint's s.
template <class S>
S blended_squared_stretch(std::span<const AffineMap<S>> maps, std::span<const S> stretches, std::span<const S> w) {
  S blended = stretches[0] * w[0];
  for (std::size_t i = 1; i < w.size(); ++i) blended = blended + stretches[i] * w[i];
  return min_of(squared_stretch(blended_map(maps, w)), sq(blended));
}

// Returns the control ball of (v) at the weight vertex w. It holds the blend of each point of the reference ball.
template <class S>
SquaredBall<S, 3> linear_control_ball(std::span<const AffineMap<S>> maps, std::span<const S> stretches, std::span<const S> w,
                                      const SquaredBall<S, 3>& reference) {
  return {linear_blend(maps, w, reference.center), blended_squared_stretch(maps, stretches, w) * reference.squared_radius};
}

// The hypotheses of (v) are that no factor is negative or less than its joint's s.
template <class S>
Verdict are_stretches(std::span<const AffineMap<S>> maps, std::span<const S> stretches) {
  Verdict v = Verdict::holds;
  for (std::size_t i = 0; i < maps.size(); ++i)
    v &= less_equal(S(0), stretches[i]) & less_equal(squared_stretch(maps[i]), sq(stretches[i]));
  return v;
}

// Judges (v) at one weight vertex: the blend of a point of the reference ball is in the control ball.
template <class S>
Verdict is_in_control_ball(std::span<const AffineMap<S>> maps, std::span<const S> stretches, std::span<const S> w,
                           const SquaredBall<S, 3>& reference, const Vec<S, 3>& point) {
  return encloses(linear_control_ball(maps, stretches, w, reference), linear_blend(maps, w, point));
}

// --- Erratum: as if joints were rigid ---

// Judges whether the image is in a ball of the same radius, as it would be if the joint were rigid.
template <class S>
Verdict ball_is_carried_rigidly(const AffineMap<S>& map, const SquaredBall<S, 3>& ball, const Vec<S, 3>& point) {
  return encloses(SquaredBall<S, 3>{apply(map, ball.center), ball.squared_radius}, apply(map, point));
}

}  // namespace refitlab

// Sources: none.
// Used by: a2_two_phase_skinning, a3_morph_displacement; algorithms/bake/over_time/node_motions.cpp,
// algorithms/certificate/bound.cpp, algorithms/runtime/collide/affine_boxes.cpp,
// algorithms/runtime/collide/motion_bound_piece_kernel.cpp, algorithms/runtime/refit/refit_linear.hpp,
// algorithms/runtime/skinning/palette_rounding.hpp, experiments/drawings/motion.cpp,
// experiments/engines/box_program.cpp, experiments/engines/joint_kernel.cpp.
