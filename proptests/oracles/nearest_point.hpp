// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the point of a hull nearest to 0, by trying every subset of the points: slow, obvious, exact.
#pragma once

#include <optional>
#include <vector>

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/vector.hpp"

namespace proptests {

using refitlab::Rational;

// Solves the square system a x = b. Returns nothing if a is singular.
std::optional<std::vector<Rational>> solve(std::vector<std::vector<Rational>> a, std::vector<Rational> b);

// Returns the coefficients u of W_m of the nearest point sum_k u_k p_k. points must not be empty.
template <int D>
std::vector<Rational> nearest_point_coefficients(const std::vector<refitlab::Vec<Rational, D>>& points) {
  using refitlab::dot;
  std::vector<Rational> best;
  Rational least;
  for (unsigned subset = 1; subset < 1u << points.size(); ++subset) {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (subset >> k & 1) chosen.push_back(k);
    const std::size_t n = chosen.size();
    if (n > D + 1) continue;
    // The nearest point of the plane through the chosen ones has (p_i, c) = mu for each of them, and the u sum to 1.
    std::vector<std::vector<Rational>> a(n + 1, std::vector<Rational>(n + 1, Rational(1)));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) a[i][j] = dot(points[chosen[i]], points[chosen[j]]);
    a[n][n] = 0;
    std::vector<Rational> b(n + 1, Rational(0));
    b[n] = 1;
    const auto solution = solve(a, b);
    if (!solution) continue;
    std::vector<Rational> u(points.size(), Rational(0));
    refitlab::Vec<Rational, D> c = refitlab::Vec<Rational, D>::Zero();
    bool convex = true;
    for (std::size_t i = 0; i < n; ++i) {
      u[chosen[i]] = (*solution)[i];
      convex = convex && (*solution)[i] >= Rational(0);
      c += points[chosen[i]] * (*solution)[i];
    }
    if (convex && (best.empty() || refitlab::squared_norm(c) < least)) best = u, least = refitlab::squared_norm(c);
  }
  return best;
}

}  // namespace proptests
