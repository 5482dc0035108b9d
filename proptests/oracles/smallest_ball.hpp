// SPDX-License-Identifier: GPL-3.0-or-later
// Proves a ball to be the smallest one, in exact arithmetic and without any solver, and has CGAL's exact solver beside it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace proptests::oracle {

using refitlab::Rational;
template <int D>
using ExactPoint = refitlab::Vec<Rational, D>;

// Holds the claim that a ball is the smallest around points: its center is a convex combination of some of them.
template <int D>
struct BallClaim {
  ExactPoint<D> center;
  Rational squared_radius;
  std::vector<int> support;
  std::vector<Rational> coefficients;
};

template <int D>
BallClaim<D> claim_of(const auto& smallest) {
  const auto n = smallest.support_size;
  BallClaim<D> claim{refitlab::convert<Rational>(smallest.center),
                     Rational(smallest.squared_radius),
                     {smallest.support.begin(), smallest.support.begin() + n},
                     {}};
  for (int k = 0; k < n; ++k) claim.coefficients.emplace_back(smallest.coefficients[k]);
  return claim;
}

// Says whether it encloses, the support lies on the boundary, and the center is a convex combination of the support. Such a ball
// is smallest: for any center x, sum u_k ||p_k - x||^2 = squared_radius + ||center - x||^2.
template <int D>
bool certifies(std::span<const ExactPoint<D>> points, const BallClaim<D>& claim) {
  const auto squared_distance = [&](const ExactPoint<D>& p) {
    Rational sum(0);
    for (int i = 0; i < D; ++i) sum += (p[i] - claim.center[i]) * (p[i] - claim.center[i]);
    return sum;
  };
  for (const auto& p : points)
    if (squared_distance(p) > claim.squared_radius) return false;
  if (claim.support.empty() || claim.support.size() != claim.coefficients.size()) return false;
  Rational total(0);
  ExactPoint<D> blend = ExactPoint<D>::Constant(Rational(0));
  for (std::size_t k = 0; k < claim.support.size(); ++k) {
    if (claim.support[k] < 0 || claim.support[k] >= static_cast<int>(points.size())) return false;
    const ExactPoint<D>& p = points[claim.support[k]];
    if (squared_distance(p) != claim.squared_radius || claim.coefficients[k] < Rational(0)) return false;
    total += claim.coefficients[k];
    for (int i = 0; i < D; ++i) blend[i] += claim.coefficients[k] * p[i];
  }
  return total == Rational(1) && blend == claim.center;
}

// Returns a lower bound of the squared radii of enclosing balls: for u >= 0 of sum 1 and any center x, max ||p_k - x||^2 >= sum
// u_k ||p_k - x||^2 >= sum u_k ||p_k||^2 - ||sum u_k p_k||^2. The coefficients are divided by their sum. Returns -1 if one is
// negative.
template <int D>
Rational squared_radius_at_least(std::span<const ExactPoint<D>> points, const BallClaim<D>& claim) {
  Rational total(0), squares(0), square_of_mean(0);
  ExactPoint<D> mean = ExactPoint<D>::Constant(Rational(0));
  for (std::size_t k = 0; k < claim.support.size(); ++k) {
    const Rational& u = claim.coefficients[k];
    if (u < Rational(0)) return Rational(-1);
    total += u;
    for (int i = 0; i < D; ++i) {
      const Rational& x = points[claim.support[k]][i];
      mean[i] += u * x;
      squares += u * x * x;
    }
  }
  for (int i = 0; i < D; ++i) square_of_mean += mean[i] * mean[i];
  return squares / total - square_of_mean / (total * total);
}

// Returns a lower bound of the radii of balls that enclose all these balls. With vectors v_k of sum 0 and lengths at most l_k,
// sum l_k = 1, every center x has max (||x - c_k|| + r_k) >= sum (l_k r_k - <v_k, c_k>). The v_k are taken from the center given;
// a poor center gives a low bound, never a wrong one.
Rational radius_at_least(std::span<const refitlab::Ball<double, 3>> balls, const refitlab::Vec<double, 3>& center);

// Holds a + b sqrt(square), as CGAL gives the results of its exact solver.
struct RootNumber {
  Rational a, b, square;
};
bool operator<(const RootNumber& x, const Rational& y);
bool operator>(const RootNumber& x, const Rational& y);

template <int D>
struct CgalBall {
  std::array<RootNumber, D> center;
  RootNumber radius;
};

// Returns the ball of CGAL's Min_sphere_of_spheres_d over an exact number type, for D = 2, 3, 4.
template <int D>
CgalBall<D> smallest_ball_by_cgal(std::span<const refitlab::Ball<Rational, D>> balls);

}  // namespace proptests::oracle
