// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/convex_combination.hpp"

#include <utility>

namespace proptests::oracle {
namespace {

using refitlab::Rational;

// Returns the only coefficients of the chosen rows that give w, or nothing if there are none, or more than one.
std::optional<Row> solve(const std::vector<Row>& rows, const std::vector<std::size_t>& chosen, const Row& w) {
  const std::size_t n = w.size(), k = chosen.size();
  std::vector<Row> m(n, Row(k + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < k; ++c) m[i][c] = rows[chosen[c]][i];
    m[i][k] = w[i];
  }
  for (std::size_t c = 0; c < k; ++c) {
    std::size_t pivot = c;
    while (pivot < n && m[pivot][c] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(m[c], m[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == c || m[i][c] == 0) continue;
      const Rational factor = m[i][c] / m[c][c];
      for (std::size_t j = c; j <= k; ++j) m[i][j] -= factor * m[c][j];
    }
  }
  for (std::size_t i = k; i < n; ++i)
    if (m[i][k] != 0) return std::nullopt;
  Row out(k);
  for (std::size_t c = 0; c < k; ++c) out[c] = m[c][k] / m[c][c];
  return out;
}

std::optional<Row> search(const std::vector<Row>& rows, const Row& w, std::vector<std::size_t>& chosen) {
  if (!chosen.empty()) {
    if (const auto found = solve(rows, chosen, w)) {
      Row all(rows.size(), Rational(0));
      bool convex = true;
      for (std::size_t c = 0; c < chosen.size(); ++c) {
        convex = convex && (*found)[c] >= 0;
        all[chosen[c]] = (*found)[c];
      }
      if (convex) return all;
    }
  }
  if (chosen.size() == w.size()) return std::nullopt;
  for (std::size_t next = chosen.empty() ? 0 : chosen.back() + 1; next < rows.size(); ++next) {
    chosen.push_back(next);
    if (auto found = search(rows, w, chosen)) return found;
    chosen.pop_back();
  }
  return std::nullopt;
}

}  // namespace

std::optional<Row> as_convex_combination(const std::vector<Row>& rows, const Row& w) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i] == w) {
      Row all(rows.size(), Rational(0));
      all[i] = 1;
      return all;
    }
  std::vector<std::size_t> chosen;
  return search(rows, w, chosen);
}

}  // namespace proptests::oracle
