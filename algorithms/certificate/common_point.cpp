// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/common_point.hpp"

#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "algorithms/certificate/whole_numbers.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Returns 2^-e as a product of two powers that double has. The largest coordinate is 2^e times a number in [1/2, 1).
std::array<double, 2> unit_powers(const TrianglePoints& a, const TrianglePoints& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max({largest, a[i].cwiseAbs().maxCoeff(), b[i].cwiseAbs().maxCoeff()});
  int exponent;
  std::frexp(largest, &exponent);
  return {std::ldexp(1, -exponent / 2), std::ldexp(1, -(exponent - exponent / 2))};
}

}  // namespace

std::variant<CommonPoint, PartingPlane> common_point(const TrianglePoints& a, const TrianglePoints& b) {
  const DefaultFloatEnvironment environment;
  // The weights u, w >= 0 satisfy sum_i u_i a_i - sum_j w_j b_j = 0, sum_i u_i = 1 and sum_j w_j = 1. Coordinates are scaled to
  // about 1, as otherwise the numbers of a plane would be of different sizes.
  const auto powers = unit_powers(a, b);
  const CGAL::Gmpzf one(1), unit = CGAL::Gmpzf(powers[0]) * CGAL::Gmpzf(powers[1]);
  CGAL::Quadratic_program<CGAL::Gmpzf> program(CGAL::EQUAL, true, 0, false, 0);
  for (int i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) {
      program.set_a(i, c, unit * CGAL::Gmpzf(a[i][c]));
      program.set_a(3 + i, c, unit * CGAL::Gmpzf(-b[i][c]));
    }
    program.set_a(i, 3, one), program.set_a(3 + i, 4, one);
  }
  program.set_b(3, one), program.set_b(4, one);
  CGAL::Quadratic_program_options options;
  // Bland's rule comes to an end, and does not round.
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_nonnegative_linear_program(program, CGAL::Gmpzf(), options);
  if (!solution.is_infeasible()) {
    std::array<Rational, 6> numerators;
    auto x = solution.variable_numerators_begin();
    for (Rational& n : numerators) n = as_rational(*x++);
    // This is also the sum of the others.
    const Rational sum = numerators[0] + numerators[1] + numerators[2];
    CommonPoint out;
    for (int i = 0; i < 3; ++i) out.first[i] = numerators[i] / sum, out.second[i] = numerators[3 + i] / sum;
    return out;
  }
  // By Farkas' lemma there are (n, p, q) with (n, a_i) + p >= 0, -(n, b_j) + q >= 0 and p + q < 0. So (-n, a_i) <= p < -q <= (-n,
  // b_j).
  std::array<Rational, 5> y;
  auto certificate = solution.infeasibility_certificate_begin();
  for (Rational& n : y) n = as_rational(*certificate++);
  const Rational scale = make_whole(std::span(y).first(3));
  return PartingPlane{{-y[0], -y[1], -y[2]}, scale * (y[3] - y[4]) / (2 * as_rational(unit))};
}

}  // namespace refitlab
