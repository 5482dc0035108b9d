// What skinning prepares once a frame, by joint-set: signed quaternions, rotation centers and their images (paper 3).
#pragma once

#include <span>
#include <vector>

#include "algorithms/model/model.hpp"
#include "algorithms/weights/joint_sets.hpp"

namespace refitlab {

enum class Skinning {
  linear,          // v' = sum w_i C_i v
  spherical,       // Equation (1): QLERP about the rotation center of the joint-set [Kavan and Zara 2005b]
  hejl,            // Equation (1) about the joint that neighbouring bones share [Hejl 2004]
  dual_quaternion  // the rigid transform of the normalised blend of dual quaternions [Kavan et al. 2007]
};

// One joint-set in one posture. Arrays are by position in the joint-set.
template <class S>
struct JointSetPose {
  // C_{j_i}. The signs of the rotations are the skinning's: consistent within the joint-set, so that QLERP takes the short
  // way from the first joint to each other one. Bounds must use these signs (q and -q blend differently).
  std::vector<RigidTransform<S>> transforms;
  Vec<S, 3> rotation_center = {S(0), S(0), S(0)};  // r_c, reference frame
  std::vector<Vec<S, 3>> center_images;            // C_{j_i} r_c
  std::vector<Quaternion<S>> duals;                // d_i = t_i q_i / 2 of the dual quaternions q_i + eps d_i of the C_{j_i}
};

template <class S>
using SkinningPose = std::vector<JointSetPose<S>>;  // by joint-set

// Negates quaternions so that each has a non-negative dot product with the first. Then no blend with a positive first
// weight vanishes.
template <class S>
void make_signs_consistent(std::span<RigidTransform<S>> transforms) {
  for (auto& t : transforms.subspan(1))
    if (dot(transforms[0].rotation, t.rotation) < S(0)) t.rotation = -t.rotation;
}

// Fills center_images from transforms and rotation_center.
template <class S>
void place_rotation_center(JointSetPose<S>& pose, const Vec<S, 3>& rotation_center) {
  pose.rotation_center = rotation_center;
  pose.center_images.clear();
  for (const auto& t : pose.transforms) pose.center_images.push_back(apply(t, rotation_center));
}

// Fills duals from transforms, whose signs they share.
template <class S>
void place_duals(JointSetPose<S>& pose) {
  pose.duals.clear();
  for (const auto& c : pose.transforms) {
    const Vec<S, 3>& t = c.translation;
    pose.duals.push_back(multiply<S>({S(0), t[0], t[1], t[2]}, c.rotation) / S(2));
  }
}

// The frame's data of every joint-set. posture is by joint; throws ModelError if it has the wrong length, a number that is
// not finite, or a rotation whose squared length differs from 1 by more than 1e-6.
SkinningPose<double> make_skinning_pose(const Model& model, const JointSets& sets, const Posture& posture, Skinning skinning);

}  // namespace refitlab
