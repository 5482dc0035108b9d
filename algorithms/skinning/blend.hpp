// Blending one vertex, over any number type: linear, spherical by Equation (1), and by dual quaternions.
#pragma once

#include "algorithms/skinning/skinning_pose.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// sum w_i C_{j_i} v, where w is by position in the joint-set.
template <class S>
Vec<S, 3> blend_linear(const JointSetPose<S>& pose, std::span<const S> w, const Vec<S, 3>& v) {
  Vec<S, 3> sum = apply(pose.transforms[0], v) * w[0];
  for (std::size_t i = 1; i < w.size(); ++i) sum = sum + apply(pose.transforms[i], v) * w[i];
  return sum;
}

// sum w_i q_i, not normalised.
template <class S>
Quaternion<S> blend_quaternion(const JointSetPose<S>& pose, std::span<const S> w) {
  Quaternion<S> sum = pose.transforms[0].rotation * w[0];
  for (std::size_t i = 1; i < w.size(); ++i) sum = sum + pose.transforms[i].rotation * w[i];
  return sum;
}

// sum w_i C_{j_i} r_c, the linear part of Equation (1).
template <class S>
Vec<S, 3> blend_center(const JointSetPose<S>& pose, std::span<const S> w) {
  return combine<S, 3>(w, pose.center_images);
}

// What is linear in the weights in Equation (1).
template <class S>
struct BlendedJoints {
  Quaternion<S> rotation;  // sum w_i q_i, not normalised
  Vec<S, 3> center_image;  // sum w_i C_{j_i} r_c
};

// Both in one pass.
template <class S>
BlendedJoints<S> blend_joints(const JointSetPose<S>& pose, std::span<const S> w) {
  BlendedJoints<S> sum{pose.transforms[0].rotation * w[0], pose.center_images[0] * w[0]};
  for (std::size_t i = 1; i < w.size(); ++i) {
    sum.rotation = sum.rotation + pose.transforms[i].rotation * w[i];
    sum.center_image = sum.center_image + pose.center_images[i] * w[i];
  }
  return sum;
}

// Equation (1) for a rotation of this squared length, which is not zero, and x = v - r_c. Division by the squared length
// in place of a normalisation keeps it free of square roots, so that exact rationals can evaluate it.
template <class S>
Vec<S, 3> turn_and_place(const BlendedJoints<S>& blend, const S& squared_length, const Vec<S, 3>& x) {
  const Vec<S, 3> turned = rotate_scaled<S>(blend.rotation, x);
  const S scale = S(1) / squared_length;
  return turned * scale + blend.center_image;
}

// Equation (1). The blended quaternion must not be zero (signs made consistent and w_1 > 0 ensure it).
template <class S>
Vec<S, 3> blend_spherical(const JointSetPose<S>& pose, std::span<const S> w, const Vec<S, 3>& v) {
  const BlendedJoints<S> blend = blend_joints(pose, w);
  return turn_and_place<S>(blend, squared_norm(blend.rotation), v - pose.rotation_center);
}

// What is linear in the weights in blending dual quaternions.
template <class S>
struct BlendedDuals {
  Quaternion<S> rotation;  // sum w_i q_i, not normalised
  Quaternion<S> dual;      // sum w_i d_i
};

template <class S>
BlendedDuals<S> blend_duals(const JointSetPose<S>& pose, std::span<const S> w) {
  return {blend_quaternion(pose, w), combine<S, 4>(w, pose.duals)};
}

// Dual quaternion linear blending [Kavan, Collins, Zara, O'Sullivan 2007, "Skinning with dual quaternions"]: the rigid
// transform of b = sum w_i (q_i + eps d_i) = q + eps d after its normalisation. Dividing b by its norm, the dual number
// ||q|| + eps (q, d) / ||q||, takes from d its part along q; 2 d q* loses its real part by that and nothing else. So
// v' = (Im(q v q*) + 2 Im(d q*)) / ||q||^2, free of square roots. This is for a q of this squared length, not zero.
template <class S>
Vec<S, 3> move_rigidly(const BlendedDuals<S>& blend, const S& squared_length, const Vec<S, 3>& v) {
  const Vec<S, 3> turned = rotate_scaled<S>(blend.rotation, v);
  const Vec<S, 3> moved = imaginary<S>(multiply(blend.dual, conjugate(blend.rotation))) * S(2);
  return (turned + moved) / squared_length;
}

// The blended q must not be zero.
template <class S>
Vec<S, 3> blend_dual_quaternion(const JointSetPose<S>& pose, std::span<const S> w, const Vec<S, 3>& v) {
  const BlendedDuals<S> blend = blend_duals(pose, w);
  return move_rigidly<S>(blend, squared_norm(blend.rotation), v);
}

// The same by the kind of skinning.
template <class S>
Vec<S, 3> blend(Skinning skinning, const JointSetPose<S>& pose, std::span<const S> w, const Vec<S, 3>& v) {
  switch (skinning) {
    case Skinning::linear: return blend_linear(pose, w, v);
    case Skinning::dual_quaternion: return blend_dual_quaternion(pose, w, v);
    case Skinning::spherical:
    case Skinning::hejl: break;
  }
  return blend_spherical(pose, w, v);
}

}  // namespace refitlab
