// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/common_point.hpp"

#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <span>

#include "algorithms/certificate/linear_program.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

std::variant<CommonPoint, PartingPlane> common_point(const TrianglePoints& a, const TrianglePoints& b) {
  const DefaultFloatEnvironment environment;
  // Of the weights u, w >= 0: sum_i u_i a_i - sum_j w_j b_j = 0, sum_i u_i = 1 and sum_j w_j = 1.
  CGAL::Quadratic_program<double> program(CGAL::EQUAL, true, 0, false, 0);
  for (int i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) {
      program.set_a(i, c, a[i][c]);
      program.set_a(3 + i, c, -b[i][c]);
    }
    program.set_a(i, 3, 1), program.set_a(3 + i, 4, 1);
  }
  program.set_b(3, 1), program.set_b(4, 1);
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);  // which comes to an end, and does not round
  const auto solution = CGAL::solve_nonnegative_linear_program(program, CGAL::Gmpzf(), options);
  if (!solution.is_infeasible()) {
    std::array<Rational, 6> numerators;
    auto x = solution.variable_numerators_begin();
    for (Rational& n : numerators) n = as_rational(*x++);
    const Rational sum = numerators[0] + numerators[1] + numerators[2];  // which is that of the others, too
    CommonPoint out;
    for (int i = 0; i < 3; ++i) out.first[i] = numerators[i] / sum, out.second[i] = numerators[3 + i] / sum;
    return out;
  }
  // Farkas: (n, p, q) with (n, a_i) + p >= 0, -(n, b_j) + q >= 0 and p + q < 0. So (-n, a_i) <= p < -q <= (-n, b_j).
  std::array<Rational, 5> y;
  auto certificate = solution.infeasibility_certificate_begin();
  for (Rational& n : y) n = as_rational(*certificate++);
  const Rational scale = make_whole(std::span(y).first(3));
  return PartingPlane{{-y[0], -y[1], -y[2]}, scale * (y[3] - y[4]) / 2};
}

}  // namespace refitlab
