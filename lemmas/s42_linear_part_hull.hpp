// SPDX-License-Identifier: MIT
// Section 4.2, the linear part is a hull: the blends of given points are the hull of their blends at the weight vertices.
//
// Statement. Let W' be the hull of the weight vertices c_1 ... c_m (s41_weight_vertices_span) and let r_1 ... r_n be
// points of R^d. With r'_k = sum_i c_ki r_i, {sum_i w_i r_i : w in W'} = CH(r'_1, ..., r'_m). Any d: the paper uses it
// for the images C_{j_i} r_c of the rotation center (d = 3, Equation 5) and for the quaternions q_i (d = 4, section 4.3).
//
// Paper: section 4.2 and, for quaternions, section 4.3. It holds as printed.
// Notation: C_{j_i} r_c or q_i -> points[i], c_ki -> weight_vertices[k][i], r'_k or q'_k -> images[k], u -> coefficients.
//
// Proof. Swap the sums: sum_i (sum_k u_k c_ki) r_i = sum_k u_k r'_k. So the coefficients that take the weight vertices to w
// take the images to the blend, and the other way round.
#pragma once

#include <span>
#include <vector>

#include "lemmas/s41_weight_vertices_span.hpp"

namespace refitlab {

// Returns the r'_k = sum_i c_ki r_i of Equation 5.
template <class S, int D>
std::vector<Vec<S, D>> weight_vertex_images(const WeightVertices<S>& weight_vertices, std::span<const Vec<S, D>> points) {
  std::vector<Vec<S, D>> images;
  for (const auto& c : weight_vertices) images.push_back(combine<S, D>(c, points));
  return images;
}

// --- Hypotheses ---

// The weight vertices are those of W', and there is one point a weight.
template <class S, int D>
Verdict linear_part_hull_hypotheses(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices,
                                    std::span<const Vec<S, D>> points) {
  return verdict_of(points.size() == bounds.low.size()) & weight_vertices_span_hypotheses(bounds, weight_vertices);
}

// --- Witnesses and their checks ---

// x = sum_k u_k p_k with u in W_m.
template <class S, int D>
Verdict is_hull_point(std::span<const Vec<S, D>> points, const Vec<S, D>& x, std::span<const S> coefficients) {
  if (points.empty() || points.size() != coefficients.size()) return Verdict::fails;
  Verdict v = is_convex(coefficients);
  const Vec<S, D> sum = combine(coefficients, points);
  for (int i = 0; i < D; ++i) v &= equal(sum[i], x[i]);
  return v;
}

// x is not in the hull of the points: it lies strictly beyond all of them along the normal.
template <class S, int D>
Verdict separates(const Vec<S, D>& normal, const Vec<S, D>& x, std::span<const Vec<S, D>> points) {
  Verdict v = Verdict::holds;
  for (const auto& p : points) v &= less(dot(normal, p), dot(normal, x));
  return v;
}

// x = sum_i w_i r_i with w in W'.
template <class S, int D>
Verdict is_admissible_blend(const WeightBounds<S>& bounds, std::span<const Vec<S, D>> points, const Vec<S, D>& x,
                            std::span<const S> w) {
  if (points.size() != w.size()) return Verdict::fails;
  Verdict v = admits(bounds, w);
  const Vec<S, D> sum = combine(w, points);
  for (int i = 0; i < D; ++i) v &= equal(sum[i], x[i]);
  return v;
}

// --- Conclusion ---

template <class S, int D>
struct LinearPartPoint {
  Verdict verdict;
  Vec<S, D> point;
  std::vector<S> coefficients;  // u of W_m for the first inclusion, w of W' for the second
};

// The linear part is inside the hull. The witness is the u for the blend with weights w.
template <class S, int D>
LinearPartPoint<S, D> linear_part_in_hull(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices,
                                          std::span<const Vec<S, D>> points, const std::vector<S>& w) {
  const Vec<S, D> blend = combine<S, D>(w, points);
  auto span = weight_vertices_span(bounds, weight_vertices, w);
  if (span.coefficients.empty()) return {span.verdict, blend, {}};
  const auto images = weight_vertex_images(weight_vertices, points);
  const Verdict v = span.verdict & is_hull_point<S, D>(images, blend, span.coefficients);
  return {v, blend, std::move(span.coefficients)};
}

// The hull is inside the linear part. The witness is the w for the combination of the images with coefficients u.
template <class S, int D>
LinearPartPoint<S, D> hull_in_linear_part(const WeightBounds<S>& bounds, const WeightVertices<S>& weight_vertices,
                                          std::span<const Vec<S, D>> points, const std::vector<S>& coefficients) {
  const auto images = weight_vertex_images(weight_vertices, points);
  const Vec<S, D> x = combine<S, D>(coefficients, images);
  auto w = weight_vertices_combine(bounds, weight_vertices, coefficients);
  const Verdict v = w.verdict & is_admissible_blend<S, D>(bounds, points, x, w.weights);
  return {v, x, std::move(w.weights)};
}

}  // namespace refitlab

// Sources: the paper.
// Used by: b2_control_hull_encloses, b3_subdivision, b4_cap_fallback, s44_joint_sets;
// experiments/drawings/sections.cpp.
