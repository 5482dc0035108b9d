// SPDX-License-Identifier: MIT
// There are two blendings of rotations: Equation (1) of the paper, and dual quaternion linear blending. The parts that are linear
// in the weights are blended first. The image of a vertex is a quotient of polynomials in them.
#pragma once

#include <span>

#include "lemmas/vocabulary/rigid.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// Returns sum w_i q_i, which is not normalised.
template <class S>
Quaternion<S> blended_rotation(std::span<const RigidTransform<S>> transforms, std::span<const S> w) {
  Quaternion<S> sum = transforms[0].rotation * w[0];
  for (std::size_t i = 1; i < w.size(); ++i) sum = sum + transforms[i].rotation * w[i];
  return sum;
}

// These are the parts of Equation (1) that are linear in the weights.
template <class S>
struct BlendedJoints {
  Quaternion<S> rotation;  // sum w_i q_i, not normalised
  Vec<S, 3> center_image;  // sum w_i C_{j_i} r_c
};

// Computes Equation (1) for a rotation of this squared length, which is not zero, and x = v - r_c. Division by the squared length
// in place of a normalisation keeps it free of square roots, so that exact rationals can evaluate it.
template <class S>
Vec<S, 3> turn_and_place(const BlendedJoints<S>& blend, const S& squared_length, const Vec<S, 3>& x) {
  const Vec<S, 3> turned = rotate_scaled<S>(blend.rotation, x);
  const S scale = S(1) / squared_length;
  return turned * scale + blend.center_image;
}

// Computes Equation (1), Q_w(v - r_c) + sum_i w_i C_{j_i} r_c, of a vertex v about the rotation center r_c, for a blend that is not
// zero.
template <class S>
Vec<S, 3> spherical_blend(std::span<const RigidTransform<S>> transforms, std::span<const S> w, const Vec<S, 3>& center,
                          const Vec<S, 3>& v) {
  const BlendedJoints<S> blend{blended_rotation<S>(transforms, w), combine<S, 3>(w, images_of<S>(transforms, center))};
  return turn_and_place<S>(blend, squared_norm(blend.rotation), v - center);
}

// Returns d = t q / 2 of the dual quaternion q + eps d of a transform, the rotation q and then the translation t. It has the sign of
// the transform's q.
template <class S>
Quaternion<S> dual_part(const RigidTransform<S>& c) {
  return multiply(pure_quaternion(c.translation), c.rotation) / S(2);
}

// Returns Im(d q*), which is ||q||^2 / 2 times the translation of q + eps d.
template <class S>
Vec<S, 3> scaled_translation(const Quaternion<S>& dual, const Quaternion<S>& rotation) {
  const Vec<S, 3> dv = imaginary(dual), qv = imaginary(rotation);
  return dv * rotation[0] - qv * dual[0] - cross(dv, qv);
}

// A blend of dual quaternions q + eps d is linear in the weights.
template <class S>
struct BlendedDuals {
  Quaternion<S> rotation;  // sum w_i q_i, not normalised
  Quaternion<S> dual;      // sum w_i d_i
};

// Returns Im(q v q*) + 2 Im(d q*), which is ||q||^2 times the image of v by q + eps d.
template <class S>
Vec<S, 3> scaled_motion(const BlendedDuals<S>& blend, const Vec<S, 3>& v) {
  return rotate_scaled<S>(blend.rotation, v) + scaled_translation(blend.dual, blend.rotation) * S(2);
}

// Computes dual quaternion linear blending [Kavan, Collins, Zara, O'Sullivan 2007, "Skinning with dual quaternions"]: the image
// of v by the rigid transform of b = sum w_i (q_i + eps d_i) = q + eps d after its normalisation. Dividing b by its norm, the
// dual number ||q|| + eps (q, d) / ||q||, takes from d its part along q; 2 d q* loses its real part by that and nothing else. So
// v' = (Im(q v q*) + 2 Im(d q*)) / ||q||^2, free of square roots. q has this squared length, which is not zero.
template <class S>
Vec<S, 3> move_rigidly(const BlendedDuals<S>& blend, const S& squared_length, const Vec<S, 3>& v) {
  return scaled_motion(blend, v) / squared_length;
}

}  // namespace refitlab
