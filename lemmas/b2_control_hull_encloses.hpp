// SPDX-License-Identifier: MIT
// Beyond the paper: the control points hold all of a blend.
//
// Statement. Let N_I, W_I be the control points of a blend (b1_rational_bezier_simplex) with all W_I > 0. For every u
// of W_m the deformed point v'(u) is a convex combination of the points N_I / W_I. So a convex set that holds the ball
// of radius r about each of them (the hull of these balls; a ball or any other volume around them) holds v'(u) + y for
// all ||y|| <= r, and by s43_minkowski_sum the whole reference ball.
// It is enough that all pairwise W_kl = (q'_k, q'_l) > 0: for degree 2 these are the W_I, for degree 3 W_I is a mean of
// them. For degree 3 it is not needed: two quaternions of equal length, where there are no others, may be up to
// arccos(-1/2) apart, two thirds of a turn.
//
// Replaces: the sum of bounds of section 4.4, for blends within the condition.
// Notation: as in b1; B_I(u) W_I / sum -> coefficients, y -> offset, r -> radius.
//
// Proof. v'(u) = sum_I B_I(u) W_I (N_I / W_I) / sum_I B_I(u) W_I. All B_I(u) >= 0 with sum 1, so the factors are not
// negative and their sum is positive.
#pragma once

#include "lemmas/b1_rational_bezier_simplex.hpp"
#include "lemmas/s42_linear_part_hull.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns the positions N_I / W_I.
template <class S>
std::vector<Vec<S, 3>> positions(const std::vector<ControlPoint<S>>& points) {
  std::vector<Vec<S, 3>> out;
  for (const auto& p : points) out.push_back(p.numerator / p.weight);
  return out;
}

// --- Hypotheses ---

template <class S>
Verdict control_weights_are_positive(const std::vector<ControlPoint<S>>& points) {
  Verdict v = Verdict::holds;
  for (const auto& p : points) v &= less(S(0), p.weight);
  return v;
}

template <class S>
Verdict control_hull_hypotheses(const std::vector<ControlPoint<S>>& points, std::span<const S> u) {
  return control_weights_are_positive(points) & is_convex(u);
}

// The sufficient condition: all weight vertices are less than a right angle apart on S_3 (and none is 0).
template <class S>
Verdict pairs_are_positive(const std::vector<Quaternion<S>>& rotations) {
  Verdict v = Verdict::holds;
  for (std::size_t k = 0; k < rotations.size(); ++k)
    for (std::size_t l = 0; l <= k; ++l) v &= less(S(0), dot(rotations[k], rotations[l]));
  return v;
}

// --- Conclusion ---

// The witness is checked by is_blended_image for the image and is_hull_point for the coefficients.
template <class S>
struct HullCombination {
  Verdict verdict;
  Vec<S, 3> image;              // v'(u)
  std::vector<S> coefficients;  // of the control points' positions
};

template <class Blend, class S = typename Blend::Number>
HullCombination<S> image_in_control_hull(const Blend& blend, std::span<const S> u) {
  const auto points = control_points(blend);
  const ScaledPoint<S> at = blend.at(u);
  std::vector<S> coefficients;
  for (const auto& p : points) coefficients.push_back(bernstein<S>(p.index, u) * p.weight / at.denominator);
  const Vec<S, 3> image = at.numerator / at.denominator;
  const Verdict v = is_hull_point<S, 3>(positions(points), image, coefficients);
  return {v, image, std::move(coefficients)};
}

// Judges whether the ball encloses all control balls. If it does, it holds every vertex of the reference ball.
template <class S>
Verdict encloses_control_balls(const Ball3<S>& ball, const std::vector<ControlPoint<S>>& points, const S& radius) {
  Verdict v = Verdict::holds;
  for (const auto& p : positions(points)) v &= encloses(ball, Ball3<S>{p, radius});
  return v;
}

template <class Blend, class S = typename Blend::Number>
Verdict control_balls_enclose(const Blend& blend, std::span<const S> u, const Ball3<S>& ball, const S& radius,
                              const Vec<S, 3>& offset) {
  const ScaledPoint<S> at = blend.at(u);
  const Verdict bounded = less_equal(squared_norm(offset), sq(radius)) & less_equal(S(0), radius);
  return implies(bounded & encloses_control_balls(ball, control_points(blend), radius),
                 encloses<S, 3>(ball, at.numerator / at.denominator + offset));
}

}  // namespace refitlab

// Sources: the convex hull property of rational Bezier simplices [Farin, "Curves and Surfaces for CAGD"].
// Used by: b3_subdivision; experiments/drawings/control_hulls.cpp.
