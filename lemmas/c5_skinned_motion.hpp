// SPDX-License-Identifier: MIT
// Beyond the paper: how fast a skinned vertex goes, and how much it bends, by linear, spherical and dual quaternion skinning.
//
// Statement. Let a vertex v have the joints 1 ... n with constant convex weights w. Over an interval let the images x_k = C_k v
// move within X_k and the unit quaternions q_k, with the signs that skinning gives them and that do not change meanwhile,
// within Q_k (c4_chain_motion); X and Q are the widest of them, and X_f the widest as sizes are measured from a fixed point f.
// Let ||q|| >= m > 0 for q = sum w_k q_k (c3_normalized_motion). The skinned vertex v' moves within
// (i) X, by linear blending;
// (ii) Q I d + Y, by spherical blending about a fixed center r, where I is the inverse's motion of Q and m, Q counts with the
//   size 1, d = ||v - r||, and Y is the widest of the C_k r;
// (iii) (Z I) as seen from f, by dual quaternions, where Z is the widest of the products X_f,k Q_k.
// A motion that all joints share may be left out: if C_k = C D_k with rigid transforms, (i) to (iii) hold for the D_k in the
// frame of C, and v' moves within A M + b, M what they say and A, b of C. A vertex of one joint is then bounded as in c4. Where
// no m > 0 is known (ii) leaves the hull of the C_k r, blown up by d, at all times, and (iii) leaves nothing: a blend that
// vanishes carries a vertex as far as wanted (b6_dual_quaternion_ball). A center that is chosen anew in each pose may jump, and
// then so does v'; b7_motion_bound bounds it from the C_k v.
//
// Replaces: nothing in the paper, which bounds one pose at a time.
// Notation: x_k -> images, q_k -> rotations, w -> weights, f -> center of the dual blend, r -> pivot, m -> least.
//
// Proof. (i) A convex combination with constant weights has derivatives that are the same combination. (ii) R_q x = Im(q x g*)
// with g = q / ||q||^2, and Leibniz; ||q|| <= 1. (iii) With E = sum w_k (x_k - f) q_k, b6_dual_quaternion_ball has v' - f =
// Im(E q*) / ||q||^2 = Im(E g*). Skinning by C D_k is C applied to that by D_k: its blends are c q with the unit quaternion c.
#pragma once

#include "lemmas/c3_normalized_motion.hpp"
#include "lemmas/c4_chain_motion.hpp"

namespace refitlab {

template <class S>
Motion<S> widest(std::span<const Motion<S>> motions) {
  Motion<S> all = motions[0];
  for (const Motion<S>& m : motions.subspan(1)) all = widest(all, m);
  return all;
}

// (i) is widest(images). Returns the motion of (ii).
template <class S>
Motion<S> spherical_motion(std::span<const Motion<S>> pivot_images, std::span<const Motion<S>> rotations, const S& distance,
                           const S& least) {
  const Motion<S> blend = widest(rotations);
  const Motion<S> turn = product(Motion<S>{S(1), blend.speed, blend.acceleration}, inverse_motion(blend, least));
  return product(turn, at_rest(distance)) + widest(pivot_images);
}

// Returns the motion of (iii). The images' sizes are their distances from f, and so is the size of the result.
template <class S>
Motion<S> dual_motion(std::span<const Motion<S>> images, std::span<const Motion<S>> rotations, const S& least) {
  Motion<S> reach = product(images[0], rotations[0]);
  for (std::size_t k = 1; k < images.size(); ++k) reach = widest(reach, product(images[k], rotations[k]));
  return product(reach, inverse_motion(widest(rotations), least));
}

// --- Hypotheses ---

// A moment of skinning has the images of a point, the quaternions and the weights, by joint.
template <class S>
struct SkinMoment {
  std::vector<Moment<S, 3>> images;
  std::vector<Moment<S, 4>> rotations;
  std::vector<S> weights;
};

template <class S, int D>
Moment<S, D> blended(std::span<const S> w, std::span<const Moment<S, D>> moments) {
  Moment<S, D> sum{moments[0].value * w[0], moments[0].velocity * w[0], moments[0].acceleration * w[0]};
  for (std::size_t k = 1; k < w.size(); ++k)
    sum = sum + Moment<S, D>{moments[k].value * w[k], moments[k].velocity * w[k], moments[k].acceleration * w[k]};
  return sum;
}

// The joints move within their bounds, and their blend is long enough.
template <class S>
Verdict skin_hypotheses(const SkinMoment<S>& skin, std::span<const Motion<S>> images, std::span<const Motion<S>> rotations,
                        const S& least) {
  Verdict v = is_convex<S>(skin.weights) & less(S(0), least);
  for (std::size_t k = 0; k < images.size(); ++k)
    v &= moves_within(skin.images[k], images[k]) & moves_within(skin.rotations[k], rotations[k]) &
         equal(squared_norm(skin.rotations[k].value), S(1)) & is_motion(images[k]) & is_motion(rotations[k]);
  return v & less_equal(sq(least), squared_norm(blended<S, 4>(skin.weights, skin.rotations).value));
}

// --- Conclusion ---

// The witness is the skinned vertex at the moment. For dual quaternions it is as seen from f.
template <class S>
struct SkinnedMoment {
  Verdict verdict;
  Moment<S, 3> vertex;
};

// Returns E. The images are as seen from f.
template <class S>
Moment<S, 4> reach_moment(const SkinMoment<S>& skin) {
  std::vector<Moment<S, 4>> reaches;
  const auto pure = [](const Vec<S, 3>& x) { return Quaternion<S>(S(0), x[0], x[1], x[2]); };
  for (std::size_t k = 0; k < skin.images.size(); ++k) {
    const Moment<S, 3>& x = skin.images[k];
    reaches.push_back(product(Moment<S, 4>{pure(x.value), pure(x.velocity), pure(x.acceleration)}, skin.rotations[k],
                              [](const auto& a, const auto& b) { return multiply<S>(a, b); }));
  }
  return blended<S, 4>(skin.weights, reaches);
}

// Returns Im(a b*).
template <class S>
Moment<S, 3> imaginary_of_product(const Moment<S, 4>& a, const Moment<S, 4>& b) {
  return product(a, b, [](const Quaternion<S>& x, const Quaternion<S>& y) { return imaginary<S>(multiply<S>(x, conjugate(y))); });
}

template <class S>
Moment<S, 4> blend_inverse(const Moment<S, 4>& blend, const S& least) {
  return inverse_moves(blend, {S(0), S(0), S(0)}, least).moment;
}

// Judges (i).
template <class S>
SkinnedMoment<S> linear_moves(const SkinMoment<S>& skin, std::span<const Motion<S>> images) {
  const Moment<S, 3> vertex = blended<S, 3>(skin.weights, skin.images);
  return {moves_within(vertex, widest(images)), vertex};
}

// Judges (ii). arm is v - r, and the images are those of r.
template <class S>
SkinnedMoment<S> spherical_moves(const SkinMoment<S>& skin, const Vec<S, 3>& arm, std::span<const Motion<S>> images,
                                 std::span<const Motion<S>> rotations, const S& distance, const S& least) {
  const Moment<S, 4> q = blended<S, 4>(skin.weights, skin.rotations);
  const auto by_arm = [&](const Quaternion<S>& x) { return multiply<S>(x, Quaternion<S>(S(0), arm[0], arm[1], arm[2])); };
  const Moment<S, 4> moved{by_arm(q.value), by_arm(q.velocity), by_arm(q.acceleration)};
  const Moment<S, 3> vertex = imaginary_of_product(moved, blend_inverse(q, least)) + blended<S, 3>(skin.weights, skin.images);
  return {moves_within(vertex, spherical_motion(images, rotations, distance, least)), vertex};
}

// Judges (iii).
template <class S>
SkinnedMoment<S> dual_moves(const SkinMoment<S>& skin, std::span<const Motion<S>> images, std::span<const Motion<S>> rotations,
                            const S& least) {
  const Moment<S, 4> q = blended<S, 4>(skin.weights, skin.rotations);
  const Moment<S, 3> vertex = imaginary_of_product(reach_moment(skin), blend_inverse(q, least));
  return {moves_within(vertex, dual_motion(images, rotations, least)), vertex};
}

// Checks the witness independently and without quotients: ||q||^2 times the vertex is Im(E q*), with both derivatives
// (is_divided).
template <class S>
Verdict is_dual_moment(const SkinMoment<S>& skin, std::span<const Motion<S>> images, std::span<const Motion<S>> rotations,
                       const S& least, const Moment<S, 3>& vertex) {
  const Moment<S, 4> q = blended<S, 4>(skin.weights, skin.rotations);
  return is_divided<S, 3>(q, vertex, imaginary_of_product(reach_moment(skin), q)) &
         moves_within(vertex, dual_motion(images, rotations, least));
}

template <class S>
Verdict is_spherical_moment(const SkinMoment<S>& skin, const Vec<S, 3>& arm, std::span<const Motion<S>> images,
                            std::span<const Motion<S>> rotations, const S& distance, const S& least, const Moment<S, 3>& vertex) {
  const Moment<S, 4> q = blended<S, 4>(skin.weights, skin.rotations);
  const Moment<S, 3> placed = blended<S, 3>(skin.weights, skin.images);
  const Vec<S, 3> still = Vec<S, 3>::Constant(S(0));
  const Moment<S, 3> turned{vertex.value - placed.value, vertex.velocity - placed.velocity,
                            vertex.acceleration - placed.acceleration};
  return is_divided<S, 3>(q, turned, turned_moment<S>(q, {arm, still, still})) & less_equal(squared_norm(arm), sq(distance)) &
         moves_within(vertex, spherical_motion(images, rotations, distance, least));
}

}  // namespace refitlab

// Sources: none; for the blending [Kavan, Collins, Zara, O'Sullivan 2007, "Skinning with dual quaternions"], for fixed centers
// [Le, Hodgins 2016, "Real-time skeletal skinning with optimized centers of rotation"].
// Used by: algorithms/bake/over_time/moving_vertices.cpp, experiments/drawings/motion.cpp.
