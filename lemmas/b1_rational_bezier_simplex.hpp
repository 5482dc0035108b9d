// SPDX-License-Identifier: MIT
// Beyond the paper: blend skinning is a rational Bezier simplex in the weights.
//
// Statement. Let the weight vertices k = 1 ... m, which span a simplex, carry what is linear in the weights, and let u
// have the sum 1. A sum over I = (j <= k <= l) takes each multi-index once, with the Bernstein polynomial B_I(u): the
// product of u_j, u_k, u_l times the number of orderings of I. The deformed point is v'(u) = sum_I B_I(u) N_I / sum_I
// B_I(u) W_I, with
// - degree 1, linear blending, p_k the images of the point: W_k = 1, N_k = p_k;
// - degree 2, dual quaternions q_k + eps d_k, v' = (Im(q p q*) + 2 Im(d q*)) / ||q||^2 of the blended q, d:
//     W_kl = (q_k, q_l),  N_kl = P_kl + T_kl,  P_kl = Im(q_k p q_l* + q_l p q_k*) / 2,  T_kl = Im(d_k q_l* + d_l q_k*);
// - degree 3, spherical blending, Equation (1) of the paper: v' = Im(q x q*) / ||q||^2 + r', x = p - r_c:
//     W_jkl = (W_jk + W_kl + W_jl) / 3,  N_jkl = (P_jk + P_kl + P_jl) / 3 + (r'_j W_kl + r'_k W_jl + r'_l W_jk) / 3.
// The denominators are 1, ||q(u)||^2 and ||q(u)||^2: where the blend is not 0, v'(u) is what the skinning makes.
//
// Goes beyond: section 4.3, which bounds the rotation and section 4.2, which bounds the linear part, apart from each
// other.
// Notation: q'_k -> rotations[k], r'_k -> center_images[k], I -> ControlPoint::index, N_I, W_I -> numerator, weight.
//
// Proof. Both sides are homogeneous polynomials of the degree in u (1 = sum u raises a degree), and the N_I, W_I are
// the coefficients of their symmetric multilinear forms. Such polynomials are equal if they agree at the points of W_m
// whose coordinates are multiples of 1 / degree: so finitely many exact comparisons decide the statement for all u at
// once.
#pragma once

#include <span>
#include <vector>

#include "lemmas/vocabulary/blending.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// A deformed point N / D is kept as its numerator N and its denominator D.
template <class S>
struct ScaledPoint {
  Vec<S, 3> numerator;
  S denominator;
};

// A control point N_I / W_I belongs to the weight vertices of a sorted multi-index I.
template <class S>
struct ControlPoint {
  std::vector<std::size_t> index;
  Vec<S, 3> numerator;
  S weight;
};

// Control points stray far from the surface where rotations are far apart. Weight vertices are near if W_kl > 0, and this times
// W_kl^2 is above W_kk W_ll: of degree 3 they are less than 120 degrees of rotation apart, and of degree 2 less than 90.
inline constexpr double near_of_degree_three = 4, near_of_degree_two = 2;

// A mixed pair holds W_kl of two weight vertices, and with it P_kl, or N_kl for degree 2.
template <class S>
struct MixedPair {
  S weight;
  Vec<S, 3> numerator;
};

// Says whether W_kl > 0 and near W_kl^2 > W_kk W_ll beyond doubt. Packs get an answer for each lane.
template <class S>
auto are_near(const S& w_kl, const S& w_kk, const S& w_ll, double near) {
  return certainly_less(S(0), w_kl) && certainly_less(S(w_kk * w_ll), S(sq(w_kl) * constant<S>(near)));
}

// Returns W_kl and P_kl. With q = (w, v): P_kl = (w_k w_l - v_k.v_l) x + (v_k.x) v_l + (v_l.x) v_k + (w_k v_l + w_l v_k) x x.
template <class S>
MixedPair<S> mix_rotations(const Quaternion<S>& a, const Quaternion<S>& b, const Vec<S, 3>& x) {
  const Vec<S, 3> va = imaginary(a), vb = imaginary(b);
  const S real = a[0] * b[0], imag = dot(va, vb);
  const Vec<S, 3> turn = cross<S>(vb * a[0] + va * b[0], x);
  return {real + imag, x * (real - imag) + vb * dot(va, x) + va * dot(vb, x) + turn};
}

// Returns the control point of degree 2: W_kl and N_kl = P_kl + T_kl.
template <class S>
MixedPair<S> mix_motions(const BlendedDuals<S>& a, const BlendedDuals<S>& b, const Vec<S, 3>& point) {
  const MixedPair<S> turned = mix_rotations(a.rotation, b.rotation, point);
  return {turned.weight, turned.numerator + scaled_translation(a.dual, b.rotation) + scaled_translation(b.dual, a.rotation)};
}

// Returns the control point of degree 3, as 3 N_jkl and 3 W_jkl. It takes the mixed pairs and the center images of its weight
// vertices.
template <class S>
ScaledPoint<S> spherical_control_point(const MixedPair<S>& jk, const MixedPair<S>& kl, const MixedPair<S>& jl,
                                       const Vec<S, 3>& center_j, const Vec<S, 3>& center_k, const Vec<S, 3>& center_l) {
  const Vec<S, 3> turned = jk.numerator + kl.numerator + jl.numerator;
  const Vec<S, 3> moved = center_j * kl.weight + center_k * jl.weight + center_l * jk.weight;
  return {turned + moved, jk.weight + kl.weight + jl.weight};
}

// --- The three kinds of blending: their value at u, and their control points ---

template <class S>
struct LinearBlend {
  using Number = S;
  static constexpr int degree = 1;
  std::vector<Vec<S, 3>> images;  // p_k

  std::size_t weight_vertex_count() const { return images.size(); }
  ScaledPoint<S> at(std::span<const S> u) const { return {combine<S, 3>(u, images), S(1)}; }
  ControlPoint<S> control_point(const std::vector<std::size_t>& index) const { return {index, images[index[0]], S(1)}; }
};

template <class S>
struct DualQuaternionBlend {
  using Number = S;
  static constexpr int degree = 2;
  std::vector<Quaternion<S>> rotations;  // q_k
  std::vector<Quaternion<S>> duals;      // d_k = t_k q_k / 2 for the rotation q_k and then a translation t_k
  Vec<S, 3> point;

  std::size_t weight_vertex_count() const { return rotations.size(); }
  ScaledPoint<S> at(std::span<const S> u) const {
    const BlendedDuals<S> blend{combine<S, 4>(u, rotations), combine<S, 4>(u, duals)};
    return {scaled_motion(blend, point), squared_norm(blend.rotation)};
  }
  ControlPoint<S> control_point(const std::vector<std::size_t>& index) const {
    const std::size_t k = index[0], l = index[1];
    const auto mixed = mix_motions<S>({rotations[k], duals[k]}, {rotations[l], duals[l]}, point);
    return {index, mixed.numerator, mixed.weight};
  }
};

template <class S>
struct SphericalBlend {
  using Number = S;
  static constexpr int degree = 3;
  std::vector<Quaternion<S>> rotations;  // q'_k
  std::vector<Vec<S, 3>> center_images;  // r'_k
  Vec<S, 3> x;                           // p - r_c

  std::size_t weight_vertex_count() const { return rotations.size(); }
  ScaledPoint<S> at(std::span<const S> u) const {
    const Quaternion<S> q = combine<S, 4>(u, rotations);
    const S length = squared_norm(q);
    return {rotate_scaled(q, x) + combine<S, 3>(u, center_images) * length, length};
  }
  ControlPoint<S> control_point(const std::vector<std::size_t>& index) const {
    const std::size_t j = index[0], k = index[1], l = index[2];
    const auto mix = [&](std::size_t a, std::size_t b) { return mix_rotations(rotations[a], rotations[b], x); };
    const ScaledPoint<S> thrice =
        spherical_control_point(mix(j, k), mix(k, l), mix(j, l), center_images[j], center_images[k], center_images[l]);
    return {index, thrice.numerator / S(3), thrice.denominator / S(3)};
  }
};

// --- Multi-indices and Bernstein polynomials ---

// Calls visit(index) for each sorted list of `degree` weight vertices out of m, extending the given one.
template <class Visit>
void for_each_index(std::size_t m, int degree, Visit&& visit, std::vector<std::size_t> index = {}) {
  if (static_cast<int>(index.size()) == degree) return visit(index);
  for (std::size_t k = index.empty() ? 0 : index.back(); k < m; ++k) {
    index.push_back(k);
    for_each_index(m, degree, visit, index);
    index.pop_back();
  }
}

// Returns B_I(u).
template <class S>
S bernstein(const std::vector<std::size_t>& index, std::span<const S> u) {
  int orderings = 1, repeats = 0;
  S product(1);
  for (std::size_t i = 0; i < index.size(); ++i) {
    repeats = i > 0 && index[i] == index[i - 1] ? repeats + 1 : 1;
    orderings = orderings * static_cast<int>(i + 1) / repeats;
    product = product * u[index[i]];
  }
  return product * S(orderings);
}

// --- Hypotheses ---

template <class S>
Verdict bezier_simplex_hypotheses(std::span<const S> u) {
  S sum(0);
  for (const S& x : u) sum = sum + x;
  return equal(sum, S(1));
}

// The deformed point exists: the blend is not 0.
template <class Blend, class S = typename Blend::Number>
Verdict blend_has_image(const Blend& blend, std::span<const S> u) {
  return less(S(0), blend.at(u).denominator);
}

// v' is what the skinning makes: D v' = N. Where the blend is 0 this holds for every v'.
template <class Blend, class S = typename Blend::Number>
Verdict is_blended_image(const Blend& blend, std::span<const S> u, const Vec<S, 3>& image) {
  const ScaledPoint<S> at = blend.at(u);
  Verdict v = Verdict::holds;
  for (int i = 0; i < 3; ++i) v &= equal(S(at.denominator * image[i]), at.numerator[i]);
  return v;
}

// --- Witness and its check ---

// Returns sum_I B_I(u) N_I and sum_I B_I(u) W_I.
template <class S>
ScaledPoint<S> evaluate(const std::vector<ControlPoint<S>>& points, std::span<const S> u) {
  ScaledPoint<S> sum{Vec<S, 3>::Constant(S(0)), S(0)};
  for (const auto& p : points) {
    const S b = bernstein<S>(p.index, u);
    sum.numerator = sum.numerator + p.numerator * b;
    sum.denominator = sum.denominator + p.weight * b;
  }
  return sum;
}

template <class Blend, class S = typename Blend::Number>
Verdict agrees_at(const Blend& blend, const std::vector<ControlPoint<S>>& points, std::span<const S> u) {
  const ScaledPoint<S> sum = evaluate<S>(points, u), at = blend.at(u);
  Verdict v = equal(sum.denominator, at.denominator);
  for (int i = 0; i < 3; ++i) v &= equal(sum.numerator[i], at.numerator[i]);
  return v;
}

// The numerator and the denominator of the blend and of the simplex agree for every u of sum 1.
template <class Blend, class S = typename Blend::Number>
Verdict is_bezier_simplex(const Blend& blend, const std::vector<ControlPoint<S>>& points) {
  Verdict v = Verdict::holds;
  for_each_index(blend.weight_vertex_count(), Blend::degree, [&](const std::vector<std::size_t>& index) {
    std::vector<S> u(blend.weight_vertex_count(), S(0));
    for (const std::size_t k : index) u[k] = u[k] + S(1) / S(Blend::degree);
    v &= agrees_at<Blend, S>(blend, points, u);
  });
  return v;
}

// --- Conclusion ---

template <class Blend, class S = typename Blend::Number>
std::vector<ControlPoint<S>> control_points(const Blend& blend) {
  std::vector<ControlPoint<S>> points;
  for_each_index(blend.weight_vertex_count(), Blend::degree,
                 [&](const std::vector<std::size_t>& index) { points.push_back(blend.control_point(index)); });
  return points;
}

template <class S>
struct BezierSimplex {
  Verdict verdict;  // of the statement at u
  std::vector<ControlPoint<S>> points;
};

template <class Blend, class S = typename Blend::Number>
BezierSimplex<S> bezier_simplex(const Blend& blend, std::span<const S> u) {
  auto points = control_points(blend);
  const Verdict v = agrees_at<Blend, S>(blend, points, u);
  return {v, std::move(points)};
}

}  // namespace refitlab

// Sources: rational Bezier simplices [Farin, "Curves and Surfaces for CAGD"]; dual quaternion skinning [Kavan et al.
// 2008].
// Used by: b2_control_hull_encloses, b3_subdivision, b5_rotation_axis, b6_dual_quaternion_ball, b7_motion_bound;
// algorithms/certificate/bound.cpp, algorithms/runtime/collide/box_lanes.hpp,
// algorithms/runtime/refit/control_hull.hpp, algorithms/runtime/refit/refit_dual_quaternion.hpp,
// experiments/drawings/control_hulls.cpp.
