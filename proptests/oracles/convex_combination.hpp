// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether a point is a convex combination of others, in exact arithmetic, by trying every simplex of them.
#pragma once

#include <optional>
#include <vector>

#include "lemmas/exact/exact.hpp"

namespace proptests::oracle {

using Row = std::vector<refitlab::Rational>;

// Returns coefficients, one for each row, non-negative and of sum 1, or nothing if w is not in the hull [Caratheodory]. All rows,
// and w, have the sum 1. It is slow: there are as many linear systems as there are sets of at most w.size() rows.
std::optional<Row> as_convex_combination(const std::vector<Row>& rows, const Row& w);

}  // namespace proptests::oracle
