// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/nearest_point.hpp"

namespace proptests {

std::optional<std::vector<Rational>> solve(std::vector<std::vector<Rational>> a, std::vector<Rational> b) {
  const std::size_t n = b.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && a[pivot][column] == Rational(0)) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(a[pivot], a[column]);
    std::swap(b[pivot], b[column]);
    for (std::size_t row = 0; row < n; ++row) {
      if (row == column) continue;
      const Rational factor = a[row][column] / a[column][column];
      for (std::size_t j = column; j < n; ++j) a[row][j] -= factor * a[column][j];
      b[row] -= factor * b[column];
    }
  }
  for (std::size_t row = 0; row < n; ++row) b[row] /= a[row][row];
  return b;
}

}  // namespace proptests
