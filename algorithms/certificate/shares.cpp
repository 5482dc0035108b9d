// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/shares.hpp"

#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <algorithm>

#include "algorithms/certificate/whole_numbers.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

std::optional<Shares> find_shares(const std::vector<std::span<const double>>& weight_vertices, std::span<const double> weights) {
  const DefaultFloatEnvironment environment;
  for (std::size_t k = 0; k < weight_vertices.size(); ++k)
    if (std::ranges::equal(weight_vertices[k], weights)) return Shares{{k}, {1}};
  CGAL::Quadratic_program<double> program(CGAL::EQUAL, true, 0, false, 0);  // A x = b, x >= 0, any such x
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (std::size_t k = 0; k < weight_vertices.size(); ++k)
      program.set_a(static_cast<int>(k), static_cast<int>(i), weight_vertices[k][i]);
    program.set_b(static_cast<int>(i), weights[i]);
  }
  for (std::size_t k = 0; k < weight_vertices.size(); ++k) program.set_c(static_cast<int>(k), 0);
  const auto solution = CGAL::solve_nonnegative_linear_program(program, CGAL::Gmpzf());
  if (solution.is_infeasible()) return {};
  Shares out;
  std::size_t k = 0;
  for (auto x = solution.variable_numerators_begin(); x != solution.variable_numerators_end(); ++x, ++k)
    if (*x != CGAL::Gmpzf(0)) out.places.push_back(k), out.shares.push_back(as_rational(*x));
  make_whole(out.shares);
  return out;
}

}  // namespace refitlab
