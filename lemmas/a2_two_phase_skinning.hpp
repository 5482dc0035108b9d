// SPDX-License-Identifier: MIT
// Beyond the paper: joints that scale, with spherical and dual quaternion skinning: scales first, then rotations.
//
// Statement. Let joints be C_i = R_i S_i, with an affine S_i (scale and shear) followed by a rigid R_i. Skinning in two phases,
// as engines do, blends v'' = sum w_i S_i v and then carries v'' by the rigid blend of the R_i with the same weights.
// (i) A convex set that holds all S_i v holds v''. Such a set is a ball, or a box, that encloses the images of the reference ball
// by all S_i (a1_affine_image).
// (ii) A bound of the rigid skinning of every point of that set, with any weights, also bounds v'. So refits of rigid joints need
// only another reference ball, which is made anew where a scale changes.
// Where all S_i are one S, v'' = S v; where S_i = 1 it is the rigid skinning; and one joint gives C_i v.
//
// Replaces: section 3, where joints are rigid.
// Notation: S_i -> scales, w -> coefficients, v'' -> scaled.
//
// Proof. (i) v'' is a convex combination of the S_i v. (ii) v' is the rigid skinning of v'', which is in the set.
#pragma once

#include "lemmas/a1_affine_image.hpp"

namespace refitlab {

// Returns the balls whose hull holds every v''. A ball around them is a reference ball for a refit of the rigid joints.
template <class S>
std::vector<SquaredBall<S, 3>> scaled_balls(std::span<const AffineMap<S>> scales, const SquaredBall<S, 3>& reference) {
  std::vector<SquaredBall<S, 3>> out;
  for (const AffineMap<S>& scale : scales) out.push_back(image_of_ball(scale, reference));
  return out;
}

// --- Hypotheses ---

// The ball encloses the vertex's images by all scales, and the weights are convex.
template <class S>
Verdict two_phase_hypotheses(std::span<const AffineMap<S>> scales, const SquaredBall<S, 3>& around, const Vec<S, 3>& vertex,
                             std::span<const S> w) {
  Verdict v = is_convex(w);
  for (const AffineMap<S>& scale : scales) v &= encloses(around, apply(scale, vertex));
  return v;
}

// --- Conclusion ---

// The witness is v''.
template <class S>
struct ScaledVertex {
  Verdict verdict;
  Vec<S, 3> scaled;
};

template <class S>
ScaledVertex<S> stays_in_scaled_ball(std::span<const AffineMap<S>> scales, const SquaredBall<S, 3>& around,
                                     const Vec<S, 3>& vertex, std::span<const S> w) {
  const Vec<S, 3> scaled = linear_blend(scales, w, vertex);
  return {encloses(around, scaled), scaled};
}

// Checks the witness independently: v'' is the vertex's image by the blended matrix, and it is in the ball.
template <class S>
Verdict is_scaled_vertex(std::span<const AffineMap<S>> scales, const SquaredBall<S, 3>& around, const Vec<S, 3>& vertex,
                         std::span<const S> w, const Vec<S, 3>& scaled) {
  Verdict v = encloses(around, scaled);
  for (int i = 0; i < 3; ++i) {
    S sum(0);
    for (int j = 0; j < 4; ++j) {
      S entry(0);
      for (std::size_t k = 0; k < scales.size(); ++k)
        entry = entry + w[k] * (j < 3 ? scales[k].columns[j][i] : scales[k].offset[i]);
      sum = sum + (j < 3 ? S(entry * vertex[j]) : entry);
    }
    v &= equal(scaled[i], sum);
  }
  return v;
}

// --- Erratum: the reference ball itself ---

// Judges what a refit without scales assumes: v'' is in the reference ball.
template <class S>
Verdict stays_in_reference_ball(std::span<const AffineMap<S>> scales, const SquaredBall<S, 3>& reference, const Vec<S, 3>& vertex,
                                std::span<const S> w) {
  return encloses(reference, linear_blend(scales, w, vertex));
}

}  // namespace refitlab

// Sources: none; for the two phases [Kavan, Collins, Zara, O'Sullivan 2008, "Geometric skinning with approximate dual
// quaternion blending"].
// Used by: experiments/drawings/motion.cpp.
