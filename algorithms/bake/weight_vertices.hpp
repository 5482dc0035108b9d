// SPDX-License-Identifier: GPL-3.0-or-later
// Weight vertices are the vertices c_1 ... c_m of the polytope W' = {w : l_i <= w_i <= h_i, sum w_i = 1} (paper 4.1, Equation 4).
//
// W' is a box cut by a hyperplane. So at a weight vertex at most one coordinate lies strictly between its bounds. The
// search fixes each coordinate at its low or high bound, or leaves it free (once). It turns back where a sum of 1 is
// impossible. In arithmetic without rounding (exact numbers, or doubles that are multiples of 2^-24) it finds every weight
// vertex exactly once. A branch that ends without a weight vertex holds points of W' whose free coordinate could only be at
// a bound, and the search has found those weight vertices before. So n coordinates and a limit of k weight vertices take at
// most O(n^2 k) steps, however many there are in all.
#pragma once

#include <optional>
#include <vector>

#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

template <class S>
class WeightVertexSearch {
 public:
  WeightVertexSearch(const WeightBounds<S>& bounds, std::size_t limit)
      : bounds_(bounds),
        limit_(limit),
        n_(bounds.low.size()),
        low_after_(n_ + 1, S(0)),
        high_after_(n_ + 1, S(0)),
        w_(n_) {
    for (std::size_t i = n_; i-- > 0;) {
      low_after_[i] = low_after_[i + 1] + bounds.low[i];
      high_after_[i] = high_after_[i + 1] + bounds.high[i];
    }
  }

  // Returns the weight vertices as rows, or nothing if there are more than the limit. Empty rows mean an empty W'.
  std::optional<std::vector<std::vector<S>>> run() {
    bool is_box = true;
    for (std::size_t i = 0; i < n_; ++i) is_box = is_box && !(bounds_.high[i] < bounds_.low[i]);
    if (is_box) visit(0, S(0), n_);
    if (rows_.size() > limit_) return std::nullopt;
    return std::move(rows_);
  }

 private:
  // The coordinates before i are set and sum to fixed. The free coordinate (if free < i) is not counted.
  void visit(std::size_t i, const S& fixed, std::size_t free) {
    if (rows_.size() > limit_) return;
    const S low_free = free < n_ ? bounds_.low[free] : S(0), high_free = free < n_ ? bounds_.high[free] : S(0);
    if (S(1) < fixed + low_free + low_after_[i] || fixed + high_free + high_after_[i] < S(1)) return;
    if (i == n_) return finish(fixed, free);
    const S &low = bounds_.low[i], &high = bounds_.high[i];
    w_[i] = low;
    visit(i + 1, fixed + low, free);
    if (!(low < high)) return;
    w_[i] = high;
    visit(i + 1, fixed + high, free);
    if (free == n_) visit(i + 1, fixed, i);
  }

  void finish(const S& fixed, std::size_t free) {
    if (free < n_) {
      w_[free] = S(1) - fixed;
      // At a bound, this is the weight vertex that the search without a free coordinate finds.
      if (!(bounds_.low[free] < w_[free] && w_[free] < bounds_.high[free])) return;
    } else if (!(fixed == S(1))) {
      return;
    }
    rows_.push_back(w_);
  }

  const WeightBounds<S>& bounds_;
  const std::size_t limit_, n_;
  std::vector<S> low_after_, high_after_, w_;  // sums of the bounds from a coordinate on; the weights being built
  std::vector<std::vector<S>> rows_;
};

// Returns all weight vertices of W', or nothing if there are more than limit. Their number can grow as n C(n-1,
// floor((n-1)/2)): 1, 2, 6, 12, 30, 60 for n = 1 ... 6.
template <class S>
std::optional<std::vector<std::vector<S>>> enumerate_weight_vertices(const WeightBounds<S>& bounds, std::size_t limit) {
  return WeightVertexSearch<S>(bounds, limit).run();
}

// Returns the n weight vertices of {w : l_i <= w_i, sum w_i = 1}, a superset of W' that is always cheap.
template <class S>
std::vector<std::vector<S>> low_bound_simplex(const WeightBounds<S>& bounds) {
  S slack(1);
  for (const S& low : bounds.low) slack = slack - low;
  std::vector<std::vector<S>> rows(bounds.low.size(), bounds.low);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i][i] = rows[i][i] + slack;
  return rows;
}

// Beyond this many weight vertices, a node falls back on the simplex. The limit admits the box cuts of up to 7 joints (140)
// in full.
inline constexpr std::size_t weight_vertex_limit = 140;

template <class S>
std::vector<std::vector<S>> weight_vertices_or_simplex(const WeightBounds<S>& bounds) {
  auto weight_vertices = enumerate_weight_vertices(bounds, weight_vertex_limit);
  return weight_vertices ? std::move(*weight_vertices) : low_bound_simplex(bounds);
}

}  // namespace refitlab
