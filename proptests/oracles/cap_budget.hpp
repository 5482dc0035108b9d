// SPDX-License-Identifier: GPL-3.0-or-later
// Derives what rounding may make of Algorithm 1 and of the caps that control hulls fall back on, by the formulas' own templates.
#pragma once

#include <algorithm>
#include <cmath>

#include "lemmas/rotation_bound.hpp"
#include "proptests/oracles/norm_budget.hpp"

namespace proptests::oracle {

// Returns the error of sum w_i v_i, in u, of so many vectors of length 1, each with this error. It is linear in the weights, and
// so greatest at a vertex of their simplex. The weights are exact.
template <int D>
double error_of_blend(int joints, double of_vector) {
  // This stands in place of 0, with which sums would be exact.
  constexpr double tiny = 1e-30;
  double worst = 0;
  for (int most = 0; most < joints; ++most) {
    std::vector<Budget> w(joints, Budget(tiny));
    w[most] = Budget(1 - joints * tiny - 0x1p-24);
    const std::vector<refitlab::Vec<Budget, D>> vectors(joints, of_length<0, D>(1, of_vector));
    worst = std::max(worst, whole(refitlab::combine<Budget, D>(w, vectors)).in_u());
  }
  return worst;
}

// Returns the error of v / ||v||, in u, for an exact v of any length.
inline double error_of_unit() {
  Budget::least_squared_norm = 1;
  const refitlab::Quaternion<Budget> q = of_length<0, 4>(1);
  const double error =
      std::max(whole(refitlab::Quaternion<Budget>(q * (Budget(1) / refitlab::root(refitlab::squared_norm(q))))).in_u(),
               whole(refitlab::Quaternion<Budget>(q / refitlab::root(refitlab::squared_norm(q)))).in_u());
  Budget::least_squared_norm = 0;
  return error;
}

// Returns what rotated_ball may lose of the images of an x of length 1 under a cap of less than a right angle, in u: of its
// center, of its radius, and of the angle, whose errors come from those of the unit quaternions. Beyond a right angle the ball
// has all rotations of x.
inline double error_of_cap(double of_unit, double error_of_x) {
  using namespace refitlab;
  constexpr double u = Budget::u;
  const double of_apex = error_of_unit();
  const Quaternion<Budget> apex = of_length<0, 4>(1, of_apex * u);
  const Vec<Budget, 3> x = of_length<0, 3>(1, error_of_x);
  const Budget squared = squared_norm(x), length = root(Budget(1, squared.error, 1));
  double worst = 0;
  // At a right angle, 8 s^2 (1 - s^2) is 1.
  constexpr double end = 0.1465;
  for (double least = 1e-30; least < end;) {
    const double most = least < 1e-12 ? 1e-12 : std::min(end, least * 1.01);
    const RotationBound<Budget> bound = bound_of_cap(apex, Budget(most, 0, least));
    const Vec<Budget, 3> offset = rotate(bound.apex, x) * bound.center_ratio;
    const Budget radius = bound.radius_ratio * length;
    // The chord 2 s = || n_k - a || has the errors of both and four roundings of itself, and the angle is 4 arcsin s.
    const double of_chord = of_unit + of_apex + 4 * 2 * std::sqrt(most), of_angle = 2 / std::sqrt(1 - most) * of_chord;
    worst = std::max(worst, whole(offset).in_u() + radius.in_u() + of_angle);
    least = most;
  }
  return worst;
}

}  // namespace proptests::oracle
