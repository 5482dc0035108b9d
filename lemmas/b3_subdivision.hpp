// SPDX-License-Identifier: MIT
// Beyond the paper: halving a simplex of weights at an edge tightens its control points as far as wanted.
//
// Statement. Let a spherical blend have the weight vertices (q'_i, r'_i), and let the halves at the edge (k, l) have
// its middle ((q'_k + q'_l) / 2, (r'_k + r'_l) / 2) in place of l and in place of k.
// 1. Cover: every blend with u in W_m is one of a half with u' in W_m, and the other way round. So the control points
//    of both halves together hold what those of the whole hold, if their weights are positive
//    (b2_control_hull_encloses); and if the weights of the whole are positive, the control points of a half are in the
//    hull of the whole's.
// 2. Rate: let ||q'_i - q'_k|| <= s, ||r'_i - r'_k|| <= t, ||q'_i|| <= b, ||x|| <= a. The control point of I =
//    (j, k, l) is near the surface's point at the mean u of the three weight vertices:
//      W_I ||N_I / W_I - v'(u)|| <= a s^2 / 3 + b s t / 3 + s^2 t / 5,
//    and W_I >= ||q(u)||^2 - s^2 / 6. Half the sizes s and t leave at most a quarter of the distance bound.
//    Halving the longest edge of all makes it half as long and leaves the new edges at most sqrt(3)/2 of it.
// 3. Sign: W_kl = ||(q'_k + q'_l) / 2||^2 - ||(q'_k - q'_l) / 2||^2: it is positive if and only if the blend in
//    the middle is longer than half the edge. So where no blend vanishes, all W_kl are positive once the edges are
//    short enough; and for quaternions of equal length, both parts of an edge are after one halving, unless the blend
//    in its middle is 0.
//
// Notation: as in b1; u' -> coefficients, s, t, b, a -> sizes, the mean of three weight vertices -> middle_weights.
//
// Proof. 1. u_k c_k + u_l c_l = (u_k - u_l) c_k + 2 u_l (c_k + c_l) / 2 for u_l <= u_k; control points are multilinear
// in the weight vertices. 2. With q'_i = q + e_i, r'_i = r + f_i about the means: W_I = ||q||^2 - sum ||e_i||^2 / 6,
// and W_I (N_I / W_I - v'(u)) = R_q x sum ||e_i||^2 / 6 - sum Im(e_i x e_i*) / 6 + sum f_j ((e_k, e_l) - (q, e_j)) / 3.
// Cauchy and Schwarz, with sum ||e_i||^2 <= s^2 and sum ||f_i||^2 <= t^2, leave the factors 1/3, 1/3 and 1 / (3 sqrt 3) <=
// 1/5. 3. Expand.
#pragma once

#include <algorithm>
#include <utility>

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/b2_control_hull_encloses.hpp"
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/vocabulary/nonzero.hpp"

namespace refitlab {

// A half of the simplex keeps one end of the edge that is cut. The middle replaces the other end.
struct Half {
  std::size_t kept, replaced;
};

template <class S, int D>
Vec<S, D> middle_of(const Vec<S, D>& a, const Vec<S, D>& b) {
  return (a + b) / S(2);
}

// Returns the edge to cut in a simplex of m weight vertices. It is the pair with the smallest normalised dot product W_kl,
// compared without roots or quotients; dot_of(k, l) is W_kl. Each pair of a weight vertex that may be 0 is the widest. The result
// is (1, 0) if all pairs are equally wide, and (0, 0) for a single weight vertex.
template <class S, class Dots>
std::pair<std::size_t, std::size_t> widest_edge(std::size_t m, const Dots& dot_of) {
  std::pair<std::size_t, std::size_t> widest{m > 1 ? 1 : 0, 0};
  const auto signed_square = [&](std::size_t k, std::size_t l) {
    const S w = dot_of(k, l);
    return prefer_less(w, S(0)) ? S(-sq(w)) : sq(w);
  };
  const auto lengths = [&](std::size_t k, std::size_t l) { return S(dot_of(k, k) * dot_of(l, l)); };
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t l = 0; l < k; ++l) {
      if (!is_certainly_nonzero<S>(dot_of(k, k)) || !is_certainly_nonzero<S>(dot_of(l, l))) return {k, l};
      if (prefer_less(S(signed_square(k, l) * lengths(widest.first, widest.second)),
                      S(signed_square(widest.first, widest.second) * lengths(k, l))))
        widest = {k, l};
    }
  return widest;
}

template <class S>
SphericalBlend<S> half_of(const SphericalBlend<S>& blend, const Half& half) {
  SphericalBlend<S> out = blend;
  const auto [k, l] = half;
  out.rotations[l] = middle_of(blend.rotations[k], blend.rotations[l]);
  out.center_images[l] = middle_of(blend.center_images[k], blend.center_images[l]);
  return out;
}

// --- Hypotheses ---

template <class S>
Verdict halving_hypotheses(const SphericalBlend<S>& blend, const Half& half, std::span<const S> u) {
  const std::size_t m = blend.weight_vertex_count();
  return verdict_of(half.kept < m && half.replaced < m && half.kept != half.replaced && u.size() == m) & is_convex(u);
}

// --- 1. Cover ---

// The blend with u is the blend of the half with the coefficients.
template <class S>
struct HalfPoint {
  Verdict verdict;
  Half half;
  std::vector<S> coefficients;  // u'
};

// Checks independently that both blends have the same quaternion and the same image of the rotation center. Then they deform
// vertices alike.
template <class S>
Verdict is_same_blend(const SphericalBlend<S>& a, std::span<const S> u, const SphericalBlend<S>& b, std::span<const S> v) {
  Verdict same = verdict_of(a.weight_vertex_count() == u.size() && b.weight_vertex_count() == v.size());
  if (same == Verdict::fails) return same;
  const Quaternion<S> p = combine<S, 4>(u, a.rotations), q = combine<S, 4>(v, b.rotations);
  const Vec<S, 3> r = combine<S, 3>(u, a.center_images), t = combine<S, 3>(v, b.center_images);
  for (int i = 0; i < 4; ++i) same &= equal(p[i], q[i]);
  for (int i = 0; i < 3; ++i) same &= equal(r[i], t[i]) & equal(a.x[i], b.x[i]);
  return same;
}

template <class S>
Verdict is_half_point(const SphericalBlend<S>& blend, std::span<const S> u, const HalfPoint<S>& witness) {
  return is_convex<S>(witness.coefficients) & is_same_blend<S>(blend, u, half_of(blend, witness.half), witness.coefficients);
}

// Returns the half of the edge (k, l) that holds the blend with u.
template <class S>
HalfPoint<S> halves_cover(const SphericalBlend<S>& blend, std::size_t k, std::size_t l, std::span<const S> u) {
  const Half half = prefer_less(u[k], u[l]) ? Half{l, k} : Half{k, l};
  std::vector<S> in_half(u.begin(), u.end());
  in_half[half.kept] = u[half.kept] - u[half.replaced];
  in_half[half.replaced] = S(2) * u[half.replaced];
  HalfPoint<S> out{Verdict::undecided, half, std::move(in_half)};
  out.verdict = is_half_point(blend, u, out);
  return out;
}

// Goes the other way: returns the whole's u for the u' of a half.
template <class S>
HalfPoint<S> half_in_whole(const SphericalBlend<S>& blend, const Half& half, std::span<const S> in_half) {
  std::vector<S> u(in_half.begin(), in_half.end());
  const S share = in_half[half.replaced] / S(2);
  u[half.kept] = in_half[half.kept] + share;
  u[half.replaced] = share;
  const Verdict v = is_convex<S>(u) & is_same_blend<S>(blend, u, half_of(blend, half), in_half);
  return {v, half, std::move(u)};
}

// Returns a half's control point as a convex combination of the whole's control points. The positions of its multi-index that
// hold the new weight vertex are shared out to both ends of the edge; the coefficients belong to control_points(blend).
template <class S>
HullCombination<S> half_control_point_in_hull(const SphericalBlend<S>& blend, const Half& half,
                                              const std::vector<std::size_t>& index) {
  const auto point = half_of(blend, half).control_point(index);
  const auto whole = control_points(blend);
  int shared = 0;
  for (const std::size_t i : index) shared += i == half.replaced;
  std::vector<S> coefficients(whole.size(), S(0));
  for (unsigned choice = 0; choice < 1u << shared; ++choice) {
    std::vector<std::size_t> source = index;
    int bit = 0;
    for (auto& i : source)
      if (i == half.replaced && (choice >> bit++ & 1)) i = half.kept;
    std::sort(source.begin(), source.end());
    for (std::size_t i = 0; i < whole.size(); ++i)
      if (whole[i].index == source)
        coefficients[i] = coefficients[i] + whole[i].weight / (point.weight * S(static_cast<int>(1u << shared)));
  }
  const Vec<S, 3> position = point.numerator / point.weight;
  const Verdict v = is_hull_point<S, 3>(positions(whole), position, coefficients);
  return {v, position, std::move(coefficients)};
}

// --- 2. Rate ---

template <class S>
struct SimplexSizes {
  S rotation_spread;  // s
  S center_spread;    // t, length units
  S rotation_length;  // b
  S arm;              // a, length units
};

template <class S>
Verdict sizes_bound(const SphericalBlend<S>& blend, const SimplexSizes<S>& sizes) {
  Verdict v = less_equal(squared_norm(blend.x), sq(sizes.arm)) & less_equal(S(0), sizes.arm) &
              less_equal(S(0), sizes.rotation_spread) & less_equal(S(0), sizes.center_spread) &
              less_equal(S(0), sizes.rotation_length);
  for (std::size_t k = 0; k < blend.weight_vertex_count(); ++k) {
    v &= less_equal(squared_norm(blend.rotations[k]), sq(sizes.rotation_length));
    for (std::size_t l = 0; l < k; ++l)
      v &= less_equal(squared_distance(blend.rotations[k], blend.rotations[l]), sq(sizes.rotation_spread)) &
           less_equal(squared_distance(blend.center_images[k], blend.center_images[l]), sq(sizes.center_spread));
  }
  return v;
}

// Returns the bound of W_I times the distance.
template <class S>
S distance_bound(const SimplexSizes<S>& sizes) {
  const S& s = sizes.rotation_spread;
  const S& t = sizes.center_spread;
  return sizes.arm * sq(s) / S(3) + sizes.rotation_length * s * t / S(3) + sq(s) * t / S(5);
}

// Returns the weights of the mean of the weight vertices of I.
template <class S>
std::vector<S> middle_weights(const std::vector<std::size_t>& index, std::size_t m) {
  std::vector<S> u(m, S(0));
  for (const std::size_t k : index) u[k] = u[k] + S(1) / S(static_cast<int>(index.size()));
  return u;
}

template <class S>
struct ControlPointDistance {
  Verdict verdict;
  std::vector<S> weights;  // u: where the surface comes near
  Vec<S, 3> scaled_gap;    // W_I (N_I / W_I - v'(u))
};

// Checks the witness independently: the blend is not 0 at the weights, W_I and the gap are right, and both bounds hold.
template <class S>
Verdict is_control_point_distance(const SphericalBlend<S>& blend, const std::vector<std::size_t>& index,
                                  const SimplexSizes<S>& sizes, const ControlPointDistance<S>& witness) {
  const ControlPoint<S> point = blend.control_point(index);
  const ScaledPoint<S> surface = blend.at(witness.weights);
  Verdict v = is_convex<S>(witness.weights) & less_equal(squared_norm(witness.scaled_gap), sq(distance_bound(sizes))) &
              less_equal(S(surface.denominator - sq(sizes.rotation_spread) / S(6)), point.weight);
  for (int i = 0; i < 3; ++i)
    v &= equal(S(witness.scaled_gap[i] * surface.denominator),
               S(point.numerator[i] * surface.denominator - surface.numerator[i] * point.weight));
  return v;
}

template <class S>
ControlPointDistance<S> control_point_is_near(const SphericalBlend<S>& blend, const std::vector<std::size_t>& index,
                                              const SimplexSizes<S>& sizes) {
  auto u = middle_weights<S>(index, blend.weight_vertex_count());
  const ControlPoint<S> point = blend.control_point(index);
  const ScaledPoint<S> surface = blend.at(u);
  ControlPointDistance<S> out{Verdict::undecided, std::move(u),
                              point.numerator - surface.numerator * (point.weight / surface.denominator)};
  out.verdict = is_control_point_distance(blend, index, sizes, out);
  return out;
}

// If the longest edge (a, b) is halved, the new edge from its middle to c has at most 3/4 of its squared length.
template <class S>
Verdict new_edge_is_shorter(const Quaternion<S>& a, const Quaternion<S>& b, const Quaternion<S>& c) {
  const S longest = squared_distance(a, b);
  const Quaternion<S> middle = middle_of(a, b);
  const Verdict is_longest = less_equal(squared_distance(a, c), longest) & less_equal(squared_distance(b, c), longest);
  return implies(is_longest, less_equal(S(S(4) * squared_distance(middle, c)), S(S(3) * longest)));
}

// --- 3. Sign ---

template <class S>
Verdict positive_if_middle_is_long(const Quaternion<S>& p, const Quaternion<S>& q) {
  const Quaternion<S> sum = p + q;
  const Verdict positive = less(S(0), dot(p, q)), is_long = less(squared_distance(p, q), squared_norm(sum));
  return implies(positive, is_long) & implies(is_long, positive);
}

// The quaternions have equal lengths, and their middle is not 0.
template <class S>
Verdict equal_lengths_hypotheses(const Quaternion<S>& p, const Quaternion<S>& q) {
  const Quaternion<S> sum = p + q;
  return equal(squared_norm(p), squared_norm(q)) & less(S(0), squared_norm(sum));
}

// Each dot product of the middle with an end is the middle's squared length, and so positive.
template <class S>
struct PositiveHalves {
  Verdict verdict;
  Quaternion<S> middle;
  S squared_length;
};

template <class S>
Verdict is_positive_halves(const Quaternion<S>& p, const Quaternion<S>& q, const PositiveHalves<S>& witness) {
  Verdict v = less(S(0), witness.squared_length) & equal(dot(p, witness.middle), witness.squared_length) &
              equal(dot(q, witness.middle), witness.squared_length);
  for (int i = 0; i < 4; ++i) v &= equal(S(witness.middle[i] * S(2)), S(p[i] + q[i]));
  return v;
}

template <class S>
PositiveHalves<S> halving_makes_positive(const Quaternion<S>& p, const Quaternion<S>& q) {
  const Quaternion<S> middle = middle_of(p, q);
  return {less(S(0), dot(p, middle)) & less(S(0), dot(q, middle)), middle, squared_norm(middle)};
}

}  // namespace refitlab

// Sources: de Casteljau's algorithm and its quadratic rate [Farin, "Curves and Surfaces for CAGD"]; the constants are
// ours.
// Used by: algorithms/certificate/bound.cpp, algorithms/runtime/refit/control_hull.hpp,
// algorithms/runtime/refit/refit_dual_quaternion.hpp, experiments/drawings/control_hulls.cpp.
