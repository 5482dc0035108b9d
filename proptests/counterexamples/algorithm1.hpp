// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned refits on which Algorithm 1 as printed fails or is undefined, and the repaired one holds.
#pragma once

#include <string>
#include <vector>

#include "proptests/gen/refit_case.hpp"

namespace proptests::counterexamples {

struct PinnedRefit {
  std::string finding;  // what is wrong in print
  gen::RefitCase input;
  std::vector<gen::Rational> weights;  // of a vertex at S's center, in the first joint-set
  bool undefined;                      // the printed algorithm divides by zero; else its ball misses the vertex
};

const std::vector<PinnedRefit>& algorithm1();

}  // namespace proptests::counterexamples
