// SPDX-License-Identifier: GPL-3.0-or-later
// Shares show that weights are a convex combination of the weight vertices of a piece, as numbers that anyone can check.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lemmas/exact/exact.hpp"

namespace refitlab {

// The weights are sum_k shares[k] weight_vertices[places[k]] / sum_k shares[k]. The shares are whole numbers above 0.
struct Shares {
  std::vector<std::size_t> places;
  std::vector<Rational> shares;
};

// Returns at most as many shares as there are weights, and one for a weight vertex. Returns nothing if the weights are outside
// the hull of the weight vertices. Both are taken exactly. weight_vertices has rows of as many finite numbers as there are
// weights.
std::optional<Shares> find_shares(const std::vector<std::span<const double>>& weight_vertices, std::span<const double> weights);

}  // namespace refitlab
