// SPDX-License-Identifier: MIT
// Section 4.4, several joint-sets: one ball of the balls of all joint-sets.
//
// Statement. Let S = [p, r] enclose vertices that belong to joint-sets z = 1 ... Z, each joint-set with its own joints,
// rotation center and weight vertices. If a ball [g, R] encloses the balls r'_{k,z} (+) F_z of every joint-set, then
// [g, R + r] encloses every deformed vertex of every joint-set. Here F_z is any ball that holds the turned p - r_c of
// joint-set z.
//
// Paper: section 4.4, second paragraph; lines 4-8 of Algorithm 1.
// Notation: S = [p, r] -> reference, C_{j_i} -> transforms[i], r_c -> rotation_center, c_k -> weight_vertices[k], w ->
// weights, r'_{k,z} (+) F_z -> a SquaredBall: F_z is taken as [0, ||p - r_c||], the simplest bound that is always one.
//
// Proof. s44_sum_of_bounds for each joint-set; R_q keeps lengths.
#pragma once

#include <span>
#include <vector>

#include "lemmas/s41_weight_vertices_span.hpp"
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/s43_minkowski_sum.hpp"
#include "lemmas/vocabulary/blending.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace refitlab {

template <class S>
struct PosedJointSet {
  std::vector<RigidTransform<S>> transforms;  // C_{j_1} ... C_{j_n}
  Vec<S, 3> rotation_center;                  // r_c: the skinning's, so a part of what is bounded
  WeightVertices<S> weight_vertices;          // c_1 ... c_m
};

// sqrt(a) + sqrt(b) <= c, for a, b >= 0.
template <class S>
Verdict roots_sum_at_most(const S& a, const S& b, const S& c) {
  const S rest = sq(c) - a - b;
  return less_equal(S(0), c) & less_equal(S(0), rest) & less_equal(S(S(4) * a * b), sq(rest));
}

template <class S>
Verdict encloses_part(const Ball3<S>& ball, const SquaredBall<S, 3>& part) {
  return roots_sum_at_most(squared_distance(part.center, ball.center), part.squared_radius, ball.radius);
}

// --- Erratum: whose weight vertices, whose rotation center ---
// The input of Algorithm 1 has one list of weight vertices and one rotation center, and its lines 6-8 use them for every
// joint-set.

// Printed: the weight vertices and the rotation center of the first joint-set serve all of them (which have as many
// joints).
template <class S>
std::vector<SquaredBall<S, 3>> joint_set_balls_printed(std::span<const PosedJointSet<S>> sets, const Vec<S, 3>& p) {
  std::vector<SquaredBall<S, 3>> balls;
  for (const auto& set : sets) {
    const auto images = images_of<S>(set.transforms, sets[0].rotation_center);
    for (const auto& image : weight_vertex_images<S, 3>(sets[0].weight_vertices, images))
      balls.push_back({image, squared_distance(p, sets[0].rotation_center)});
  }
  return balls;
}

// Repaired: each joint-set has its own.
template <class S>
std::vector<SquaredBall<S, 3>> joint_set_balls_repaired(std::span<const PosedJointSet<S>> sets, const Vec<S, 3>& p) {
  std::vector<SquaredBall<S, 3>> balls;
  for (const auto& set : sets) {
    const auto images = images_of<S>(set.transforms, set.rotation_center);
    for (const auto& image : weight_vertex_images<S, 3>(set.weight_vertices, images))
      balls.push_back({image, squared_distance(p, set.rotation_center)});
  }
  return balls;
}

// --- Hypotheses ---

// The vertex is in the reference ball, its weights are the given combination of its joint-set's weight vertices, and the blend is
// a rotation.
template <class S>
Verdict is_vertex_of(const PosedJointSet<S>& set, const Ball3<S>& reference, std::span<const S> w, const Vec<S, 3>& v,
                     const std::vector<S>& coefficients) {
  return is_weight_vertex_combination<S>(set.weight_vertices, {w.begin(), w.end()}, coefficients) & encloses(reference, v) &
         minkowski_sum_hypotheses(blended_rotation<S>(set.transforms, w));
}

template <class S>
Verdict encloses_parts(const Ball3<S>& ball, std::span<const SquaredBall<S, 3>> parts) {
  Verdict v = Verdict::holds;
  for (const auto& part : parts) v &= encloses_part(ball, part);
  return v;
}

// --- Conclusion ---

template <class S>
struct JointSetVertex {
  Verdict verdict;
  Vec<S, 3> linear, spherical, offset;  // the deformed vertex is their sum
};

// The three parts make the deformed vertex, the linear one is where the coefficients take the weight vertex images, and the
// other two are no longer than ||p - r_c|| and r.
template <class S>
Verdict is_joint_set_vertex(const PosedJointSet<S>& set, const Ball3<S>& reference, std::span<const S> w, const Vec<S, 3>& v,
                            const std::vector<S>& coefficients, const JointSetVertex<S>& witness) {
  const auto images = images_of<S>(set.transforms, set.rotation_center);
  const auto at_weight_vertices = weight_vertex_images<S, 3>(set.weight_vertices, images);
  const Vec<S, 3> vertex = spherical_blend<S>(set.transforms, w, set.rotation_center, v),
                  sum = witness.linear + witness.spherical + witness.offset;
  Verdict good = is_hull_point<S, 3>(at_weight_vertices, witness.linear, coefficients) &
                 less_equal(squared_norm(witness.spherical), squared_distance(reference.center, set.rotation_center)) &
                 less_equal(squared_norm(witness.offset), sq(reference.radius));
  for (int i = 0; i < 3; ++i) good &= equal(sum[i], vertex[i]);
  return good;
}

// [g, R + r] encloses the deformed vertex.
template <class S>
JointSetVertex<S> joint_set_vertex(const Ball3<S>& ball, const PosedJointSet<S>& set, const Ball3<S>& reference,
                                   std::span<const S> w, const Vec<S, 3>& v) {
  const auto images = images_of<S>(set.transforms, set.rotation_center);
  const Quaternion<S> q = blended_rotation<S>(set.transforms, w);
  return {encloses(inflate(ball, reference.radius), spherical_blend<S>(set.transforms, w, set.rotation_center, v)),
          combine<S, 3>(w, images), rotate_by<S>(q, reference.center - set.rotation_center),
          rotate_by<S>(q, v - reference.center)};
}

}  // namespace refitlab

// Sources: the paper.
// Used by: algorithms/certificate/bound.cpp.
