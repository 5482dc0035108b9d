// RotationBound: a ball around all images of a vector under a hull of quaternions (paper 4.3, repaired).
//
// The cap on S_3 around the quaternions has a unit apex a and contains every n_k = q'_k / ||q'_k||, so with the chord
// s = max ||n_k - a|| / 2 its angle beta has sin(beta/2) = s, and the cap of images in R^3 has twice that angle, alpha:
// 1 - cos alpha = 2 sin^2(alpha/2) = 8 s^2 (1 - s^2). The chord keeps all digits at small angles, where the dot product
// loses half of them. The ball around the cap (Lemma 5, repaired) has center max(cos alpha, 0) times the apex's image.
#pragma once

#include <span>

#include "algorithms/skinning/pose_rounding.hpp"

namespace refitlab {

// For every non-zero q in the hull and every x: the image of x lies within radius_ratio ||x|| of center_ratio R(apex) x.
template <class S>
struct RotationBound {
  Quaternion<S> apex;  // unit
  S center_ratio;      // in [0, 1]
  S radius_ratio;      // in [0, 1], the squares of both sum to 1
};

// No bound at all: every rotation.
template <class S>
RotationBound<S> all_rotations() {
  return {identity_quaternion<S>(), S(0), S(1)};
}

// unit: quaternions of unit length. direction: of any length, best in their middle. Where the cap would be a half-sphere
// of S_3 or more, or direction cannot be told from zero, all rotations.
template <class S>
RotationBound<S> bound_rotations(std::span<const Quaternion<S>> unit, const Quaternion<S>& direction) {
  const S squared_length = squared_norm(direction);
  if (!is_certainly_nonzero(squared_length)) return all_rotations<S>();
  const Quaternion<S> apex = direction / root(squared_length);
  S s2(0);
  for (const Quaternion<S>& q : unit) s2 = max_of(s2, squared_distance(q, apex));
  s2 = s2 / S(4);
  if (!certainly_less(s2, S(0.5))) return all_rotations<S>();
  const S one_minus_cos = min_of(S(S(8) * s2 * (S(1) - s2)), S(1));
  return {apex, S(1) - one_minus_cos, root(S(one_minus_cos * (S(2) - one_minus_cos)))};
}

}  // namespace refitlab
