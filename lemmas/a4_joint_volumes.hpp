// SPDX-License-Identifier: MIT
// Beyond the paper: volumes that joints carry, one a joint, and how far they must grow to hold linearly skinned vertices.
//
// Statement. Let rigid joints C_k carry convex volumes, let p_k be a point of the k-th one, and let the vertex v with the convex
// weights w_k be no farther than d_k from p_k. If the volumes grow by radii r_k with
//   sum w_k d_k <= sum w_k r_k,
// then v' = sum w_k C_k v is, in every pose,
// (i) within sum w_k r_k of sum w_k C_k p_k,
// (ii) in no direction e of unit length beyond all (e, C_k p_k) + r_k: so, if all r_k >= 0, it is in the hull of the grown
// volumes.
// (iii) If the inequality fails, all r_k >= 0, the d_k are the distances, and each volume is its p_k alone, there is a pose in
// which v' is outside of the hull. (A volume that reaches farther in the direction from p_k to v may hold it.)
// Volumes that hold all that their joints move have all d_k = 0 and need not grow (a1_affine_image, for any affine joints). The
// inequality asks of the mean what d_k <= r_k would ask of every joint, and a joint that moves a vertex little needs little.
//
// Replaces: one volume a bone [Heim et al. 2004], which section 2 of the paper compares with.
// Notation: p_k -> point, d_k -> distance, r_k -> growth.
//
// Proof. v' - sum w_k C_k p_k = sum w_k R_k (v - p_k), which is no longer than sum w_k d_k. (ii) Along e, v' is at most
// sum w_k ((e, C_k p_k) + r_k), a mean of what the volumes reach. (iii) Turn all v - p_k to e, and put C_k p_k to -r_k e: the
// volumes reach to 0 along e, and v' is at sum w_k (d_k - r_k).
#pragma once

#include <span>
#include <vector>

#include "lemmas/vocabulary/rigid.hpp"
#include "lemmas/vocabulary/sphere.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

template <class S>
struct CarriedVolume {
  RigidTransform<S> joint;
  Vec<S, 3> point;     // of the volume, as the reference pose has it
  S distance, growth;  // of the vertex from it, at most; by how much the volume grows
};

// Returns a joint's summand w (d - g) of the inequality, which is positive where its volume grows too little.
template <class S>
S lack_of_growth(const S& weight, const S& distance, const S& growth) {
  return weight * (distance - growth);
}

// Returns the ball of (i).
template <class S>
Ball3<S> mean_ball(std::span<const CarriedVolume<S>> volumes, std::span<const S> w) {
  Ball3<S> out{Vec<S, 3>::Constant(S(0)), S(0)};
  for (std::size_t k = 0; k < volumes.size(); ++k)
    out = {out.center + apply(volumes[k].joint, volumes[k].point) * w[k], out.radius + w[k] * volumes[k].growth};
  return out;
}

// --- Hypotheses ---

template <class S>
Verdict volumes_hypotheses(std::span<const CarriedVolume<S>> volumes, std::span<const S> w, const Vec<S, 3>& vertex) {
  Verdict v = is_convex(w);
  S lack(0);
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    v &= less_equal(S(0), volumes[k].distance);
    v &= less_equal(squared_norm<S, 3>(vertex - volumes[k].point), sq(volumes[k].distance));
    lack = lack + lack_of_growth(w[k], volumes[k].distance, volumes[k].growth);
  }
  return v & less_equal(lack, S(0));
}

// --- Conclusion ---

// The witness splits the way from the ball's center to v' into the part of each joint.
template <class S>
struct VertexAmongVolumes {
  Verdict verdict;
  std::vector<Vec<S, 3>> beside;
};

template <class S>
Vec<S, 3> skinned_among(std::span<const CarriedVolume<S>> volumes, std::span<const S> w, const Vec<S, 3>& vertex) {
  Vec<S, 3> out = Vec<S, 3>::Constant(S(0));
  for (std::size_t k = 0; k < volumes.size(); ++k) out = out + apply(volumes[k].joint, vertex) * w[k];
  return out;
}

// Judges (i).
template <class S>
VertexAmongVolumes<S> stays_in_mean_ball(std::span<const CarriedVolume<S>> volumes, std::span<const S> w,
                                         const Vec<S, 3>& vertex) {
  VertexAmongVolumes<S> out{encloses(mean_ball(volumes, w), skinned_among(volumes, w, vertex)), {}};
  for (std::size_t k = 0; k < volumes.size(); ++k)
    out.beside.push_back((apply(volumes[k].joint, vertex) - apply(volumes[k].joint, volumes[k].point)) * w[k]);
  return out;
}

// Checks the witness independently: each part is as long as the weighted way from the point to the vertex, no part is longer than
// its share of the distances, and the parts lead from the center to v'.
template <class S>
Verdict is_vertex_among(std::span<const CarriedVolume<S>> volumes, std::span<const S> w, const Vec<S, 3>& vertex,
                        std::span<const Vec<S, 3>> beside) {
  if (beside.size() != volumes.size()) return Verdict::fails;
  Verdict v = Verdict::holds;
  Vec<S, 3> sum = mean_ball(volumes, w).center;
  S lack(0);
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    v &= equal(squared_norm(beside[k]), S(sq(w[k]) * squared_norm<S, 3>(vertex - volumes[k].point)));
    v &= less_equal(squared_norm(beside[k]), sq(S(w[k] * volumes[k].distance)));
    sum = sum + beside[k];
    lack = lack + lack_of_growth(w[k], volumes[k].distance, volumes[k].growth);
  }
  const Vec<S, 3> at = skinned_among(volumes, w, vertex);
  for (int i = 0; i < 3; ++i) v &= equal(sum[i], at[i]);
  return v & less_equal(lack, S(0));
}

// Returns how far the grown volumes reach along a direction of unit length, as (ii) says.
template <class S>
S reach_along(std::span<const CarriedVolume<S>> volumes, const Vec<S, 3>& direction) {
  S reach = dot(direction, apply(volumes[0].joint, volumes[0].point)) + volumes[0].growth;
  for (const CarriedVolume<S>& k : volumes.subspan(1))
    reach = max_of(reach, S(dot(direction, apply(k.joint, k.point)) + k.growth));
  return reach;
}
template <class S>
Verdict stays_below_reach(std::span<const CarriedVolume<S>> volumes, std::span<const S> w, const Vec<S, 3>& vertex,
                          const Vec<S, 3>& direction) {
  return less_equal(dot(direction, skinned_among(volumes, w, vertex)), reach_along(volumes, direction));
}

// --- Erratum: the volume of one joint ---

// Judges (ii) with volumes that do not grow. Volumes of bones are often fitted so: each holds the vertices that its joint moves
// most.
template <class S>
Verdict stays_with_its_own_joint(std::span<const CarriedVolume<S>> volumes, std::span<const S> w, const Vec<S, 3>& vertex,
                                 const Vec<S, 3>& direction) {
  std::vector<CarriedVolume<S>> as_they_are(volumes.begin(), volumes.end());
  for (CarriedVolume<S>& k : as_they_are) k.growth = S(0);
  return stays_below_reach<S>(as_they_are, w, vertex, direction);
}

}  // namespace refitlab

// Sources: none; for volumes a bone [Heim, Marshall, Lake 2004, "Fast collision detection for 3D bones-based articulated
// characters"], as the paper cites it.
// Used by: experiments/drawings/motion.cpp, experiments/engines/weighted_radii.cpp.
