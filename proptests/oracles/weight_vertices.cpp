// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/weight_vertices.hpp"

#include <algorithm>

namespace proptests::oracle {

using refitlab::Rational;

std::set<ExactWeights> weight_vertices(const ExactBounds& bounds) {
  std::set<ExactWeights> out;
  const std::size_t n = bounds.low.size();
  for (std::size_t loose = 0; loose < n; ++loose)
    for (unsigned pattern = 0; pattern < 1u << n; ++pattern) {
      ExactWeights w(n);
      Rational others(0);
      bool admissible = true;
      for (std::size_t i = 0; i < n; ++i) {
        admissible = admissible && bounds.low[i] <= bounds.high[i];
        if (i == loose) continue;
        w[i] = pattern >> i & 1 ? bounds.high[i] : bounds.low[i];
        others += w[i];
      }
      w[loose] = Rational(1) - others;
      if (admissible && bounds.low[loose] <= w[loose] && w[loose] <= bounds.high[loose]) out.insert(w);
    }
  return out;
}

std::map<ExactWeights, Rational> as_combination_of_weight_vertices(const ExactBounds& bounds, const ExactWeights& w) {
  std::vector<std::size_t> loose;
  for (std::size_t i = 0; i < w.size(); ++i)
    if (bounds.low[i] < w[i] && w[i] < bounds.high[i]) loose.push_back(i);
  if (loose.size() < 2) return {{w, Rational(1)}};

  const std::size_t i = loose[0], j = loose[1];
  const Rational up = std::min<Rational>(bounds.high[i] - w[i], w[j] - bounds.low[j]);
  const Rational down = std::min<Rational>(w[i] - bounds.low[i], bounds.high[j] - w[j]);
  std::map<ExactWeights, Rational> out;
  const auto add_end = [&](const Rational& step, const Rational& share) {
    ExactWeights end = w;
    end[i] += step;
    end[j] -= step;
    for (const auto& [weight_vertex, coefficient] : as_combination_of_weight_vertices(bounds, end))
      out[weight_vertex] += share * coefficient;
  };
  add_end(up, down / (up + down));
  add_end(-down, up / (up + down));
  return out;
}

ExactBounds bounds_around(const std::vector<ExactWeights>& list) {
  ExactBounds bounds{list[0], list[0]};
  for (const auto& w : list)
    for (std::size_t i = 0; i < w.size(); ++i) {
      bounds.low[i] = std::min(bounds.low[i], w[i]);
      bounds.high[i] = std::max(bounds.high[i], w[i]);
    }
  return bounds;
}

}  // namespace proptests::oracle
