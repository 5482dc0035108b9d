// SPDX-License-Identifier: MIT
// Convex weights are W_n = {w in R^n : w_i >= 0, sum w_i = 1}. Weight boxes and convex combinations are here too.
#pragma once

#include <span>
#include <vector>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

// w is in W_n.
template <class S>
Verdict is_convex(std::span<const S> w) {
  Verdict v = Verdict::holds;
  S sum(0);
  for (const S& x : w) {
    v &= less_equal(S(0), x);
    sum = sum + x;
  }
  return v & equal(sum, S(1));
}

// Returns sum_k w_k p_k.
template <class S, int D>
Vec<S, D> combine(std::span<const S> w, std::span<const Vec<S, D>> points) {
  Vec<S, D> sum = points[0] * w[0];
  for (std::size_t k = 1; k < points.size(); ++k) sum = sum + points[k] * w[k];
  return sum;
}

// The bounds <l_i, h_i> of the weights of one joint-set give W' = {w : l_i <= w_i <= h_i, sum w_i = 1} (paper 4.1).
template <class S>
struct WeightBounds {
  std::vector<S> low, high;
};

template <class S>
Verdict admits(const WeightBounds<S>& bounds, std::span<const S> w) {
  Verdict v = Verdict::holds;
  S sum(0);
  for (std::size_t i = 0; i < w.size(); ++i) {
    v &= less_equal(bounds.low[i], w[i]) & less_equal(w[i], bounds.high[i]);
    sum = sum + w[i];
  }
  return v & equal(sum, S(1));
}

}  // namespace refitlab
