// SPDX-License-Identifier: MIT
// Section 4.1, weight vertices span W' (Equation 4).
//
// Statement. Weight bounds <l_i, h_i> cut W' = {w : l_i <= w_i <= h_i, sum w_i = 1} out of the plane of affine weights.
// Let the list c_1 ... c_m hold points of W' only, and each point of W' that has at most one coordinate off its bounds.
// Then every w of W' is a convex combination of the list, and every convex combination of the list is in W'. W' is
// empty unless l_i <= h_i and sum l <= 1 <= sum h. It has at most n C(n-1, floor((n-1)/2)) weight vertices.
//
// Paper: section 4.1, from [Matousek 2002] without a construction; the number of weight vertices is not bounded there.
// Notation: n -> bounds.low.size(), l_i, h_i -> bounds.low[i], bounds.high[i], c_k -> weight_vertices[k], u ->
// coefficients.
//
// Proof. From w walk away from a weight vertex v of the smallest face of W' that holds w, until a bound stops the walk
// at w': then w lies between v and w', and w' is in a smaller face. After at most n - 1 walks a weight vertex is left.
// For the number: scale the box to the unit cube and walk along its edges from all-low to all-high. The sum rises, so
// each of the n! shortest walks passes one weight vertex. One inside an edge of the cube with k coordinates high lies on
// k! (n-1-k)! of them, one at a vertex of the cube on more, and k! (n-1-k)! is least at k = floor((n-1)/2).
#pragma once

#include <optional>
#include <vector>

#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

template <class S>
using WeightVertices = std::vector<std::vector<S>>;

template <class S>
Verdict same_weights(const std::vector<S>& a, const std::vector<S>& b) {
  Verdict v = verdict_of(a.size() == b.size());
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) v &= equal(a[i], b[i]);
  return v;
}

// Calls visit(w) for the affine weights w with all coordinates but one at a bound: the only candidates for weight vertices.
template <class S, class Visit>
void for_each_weight_vertex_candidate(const WeightBounds<S>& bounds, Visit&& visit) {
  const std::size_t n = bounds.low.size();
  for (std::size_t loose = 0; loose < n; ++loose)
    for (unsigned side = 0; side < 1u << (n - 1); ++side) {
      std::vector<S> w(n);
      S rest(1);
      for (std::size_t i = 0, bit = 0; i < n; ++i) {
        if (i == loose) continue;
        w[i] = side >> bit++ & 1 ? bounds.high[i] : bounds.low[i];
        rest = rest - w[i];
      }
      w[loose] = rest;
      visit(w);
    }
}

// --- Hypotheses ---

template <class S>
Verdict weight_vertices_are_admissible(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices) {
  Verdict v = Verdict::holds;
  for (const auto& c : weight_vertices) v &= admits<S>(bounds, c);
  return v;
}

template <class S>
Verdict weight_vertices_are_complete(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices) {
  Verdict v = Verdict::holds;
  for_each_weight_vertex_candidate(bounds, [&](const std::vector<S>& candidate) {
    Verdict listed = Verdict::fails;
    for (const auto& c : weight_vertices) listed |= same_weights(c, candidate);
    v &= implies(admits<S>(bounds, candidate), listed);
  });
  return v;
}

template <class S>
Verdict weight_vertices_span_hypotheses(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices) {
  return weight_vertices_are_admissible(bounds, weight_vertices) & weight_vertices_are_complete(bounds, weight_vertices);
}

// The list repeats no point, and each point has at most one coordinate off its bounds. The number of weight vertices needs this.
template <class S>
Verdict weight_vertices_are_proper(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices) {
  Verdict v = weight_vertices_are_admissible(bounds, weight_vertices);
  for (std::size_t k = 0; k < weight_vertices.size(); ++k) {
    Verdict tight = Verdict::fails;
    for_each_weight_vertex_candidate(
        bounds, [&](const std::vector<S>& candidate) { tight |= same_weights(weight_vertices[k], candidate); });
    v &= tight;
    for (std::size_t l = 0; l < k; ++l) v &= !same_weights(weight_vertices[k], weight_vertices[l]);
  }
  return v;
}

// --- Witnesses and their checks ---

// w = sum_k u_k c_k with u in W_m.
template <class S>
Verdict is_weight_vertex_combination(const WeightVertices<S>& weight_vertices, const std::vector<S>& w,
                                     const std::vector<S>& coefficients) {
  Verdict v = verdict_of(coefficients.size() == weight_vertices.size()) & is_convex<S>(coefficients);
  for (std::size_t i = 0; i < w.size(); ++i) {
    S sum(0);
    for (std::size_t k = 0; k < weight_vertices.size() && k < coefficients.size(); ++k)
      sum = sum + coefficients[k] * weight_vertices[k][i];
    v &= equal(sum, w[i]);
  }
  return v;
}

// w is not in the hull of the points: it lies strictly beyond all of them along the normal.
template <class S>
Verdict separates(const std::vector<S>& normal, const std::vector<S>& w, const WeightVertices<S>& points) {
  Verdict v = Verdict::holds;
  for (const auto& p : points) {
    S gap(0);
    for (std::size_t i = 0; i < w.size(); ++i) gap = gap + normal[i] * (w[i] - p[i]);
    v &= less(S(0), gap);
  }
  return v;
}

// --- Conclusion ---

template <class S>
struct WeightVertexCombination {
  Verdict verdict;
  std::vector<S> coefficients;  // u: one a weight vertex, at most n of them not 0; empty if none were found
};

// W' is inside the hull of the weight vertices. The witness is the coefficients of an admissible w.
template <class S>
WeightVertexCombination<S> weight_vertices_span(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices,
                                                const std::vector<S>& w) {
  const std::size_t n = w.size();
  std::vector<S> coefficients(weight_vertices.size(), S(0)), x = w;
  std::vector<const S*> bound(n);  // the bound that coordinate i of x is known to be at
  std::size_t loose = n;
  for (std::size_t i = 0; i < n; ++i) {
    bound[i] = equal(x[i], bounds.low[i]) == Verdict::holds    ? &bounds.low[i]
               : equal(x[i], bounds.high[i]) == Verdict::holds ? &bounds.high[i]
                                                               : nullptr;
    loose -= bound[i] != nullptr;
  }
  for (S remaining(1);;) {
    // The weight vertex is in the face of x: it is at every bound that x is at.
    Verdict found = Verdict::fails;
    std::size_t k = 0;
    for (; k < weight_vertices.size(); ++k) {
      Verdict on_face = Verdict::holds;
      for (std::size_t i = 0; i < n; ++i)
        if (bound[i]) on_face &= equal(weight_vertices[k][i], *bound[i]);
      found |= on_face;
      if (on_face == Verdict::holds) break;
    }
    if (k == weight_vertices.size()) return {found, {}};
    // The step ends at the first bound on the way from the weight vertex through x.
    std::optional<S> step;
    std::size_t hit = n;
    const S* wall = nullptr;
    for (std::size_t i = 0; i < n && loose > 1; ++i) {
      const S direction = x[i] - weight_vertices[k][i];
      const bool up = certainly_less(S(0), direction), down = certainly_less(direction, S(0));
      if (bound[i] || !(up || down)) continue;
      const S& limit = up ? bounds.high[i] : bounds.low[i];
      const S t = max_of(S((limit - x[i]) / direction), S(0));  // not back, should w be outside W'
      if (!step || prefer_less(t, *step)) step = t, hit = i, wall = &limit;
    }
    if (!step) {  // x is the weight vertex
      coefficients[k] = coefficients[k] + remaining;
      return {is_weight_vertex_combination(weight_vertices, w, coefficients), coefficients};
    }
    coefficients[k] = coefficients[k] + remaining * *step / (S(1) + *step);
    remaining = remaining / (S(1) + *step);
    for (std::size_t i = 0; i < n; ++i)
      if (!bound[i]) x[i] = x[i] + *step * (x[i] - weight_vertices[k][i]);
    x[hit] = *wall;
    bound[hit] = wall;
    --loose;
  }
}

template <class S>
struct AdmissibleWeights {
  Verdict verdict;
  std::vector<S> weights;  // w
};

// The hull of the weight vertices is inside W'. The witness is the admissible weights that convex coefficients make.
template <class S>
AdmissibleWeights<S> weight_vertices_combine(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices,
                                             const std::vector<S>& coefficients) {
  std::vector<S> w(bounds.low.size(), S(0));
  for (std::size_t k = 0; k < weight_vertices.size(); ++k)
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = w[i] + coefficients[k] * weight_vertices[k][i];
  return {admits<S>(bounds, w), w};
}

// Returns n C(n-1, floor((n-1)/2)), which is 1, 2, 6, 12, 30, 60 for n = 1 ... 6.
constexpr std::size_t most_weight_vertices(std::size_t n) {
  std::size_t count = n;
  for (std::size_t k = 1; k <= (n - 1) / 2; ++k) count = count * (n - k) / k;
  return count;
}

// --- Erratum: W' may be empty ---
// The paper gives W' a hull of m points for any bounds. It is never empty for bounds taken from vertices.

// A weight vertex of W' shows that W' is not empty.
template <class S>
struct SomeWeightVertex {
  Verdict verdict;
  std::vector<S> weight_vertex;  // admissible if the verdict is that it exists
};

template <class S>
SomeWeightVertex<S> has_weight_vertex(const WeightBounds<S>& bounds) {
  SomeWeightVertex<S> best{Verdict::fails, {}};
  for_each_weight_vertex_candidate(bounds, [&](const std::vector<S>& candidate) {
    const Verdict v = admits<S>(bounds, candidate);
    if (best.verdict < v) best = {v, candidate};
  });
  return best;
}

// Printed: whatever the bounds, W' has weight vertices.
template <class S>
Verdict weight_vertices_exist_printed(const WeightBounds<S>& bounds) {
  return has_weight_vertex(bounds).verdict;
}

// l_i <= h_i and sum l <= 1 <= sum h.
template <class S>
Verdict bounds_are_compatible(const WeightBounds<S>& bounds) {
  Verdict v = Verdict::holds;
  S low(0), high(0);
  for (std::size_t i = 0; i < bounds.low.size(); ++i) {
    v &= less_equal(bounds.low[i], bounds.high[i]);
    low = low + bounds.low[i];
    high = high + bounds.high[i];
  }
  return v & less_equal(low, S(1)) & less_equal(S(1), high);
}

// Repaired: W' has weight vertices if and only if the bounds are compatible.
template <class S>
Verdict weight_vertices_exist_repaired(const WeightBounds<S>& bounds) {
  const Verdict compatible = bounds_are_compatible(bounds), exists = has_weight_vertex(bounds).verdict;
  return implies(compatible, exists) & implies(exists, compatible);
}

}  // namespace refitlab

// Sources: Matousek, Lectures on Discrete Geometry, 2002 (bounded H-polytopes are V-polytopes); O'Neil, Hyperplane cuts
// of an n-cube, Discrete Mathematics 1, 1971 (the number of edges cut).
// Used by: s42_linear_part_hull, s44_joint_sets; algorithms/certificate/bound.cpp.
