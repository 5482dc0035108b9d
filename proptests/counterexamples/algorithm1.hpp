// SPDX-License-Identifier: GPL-3.0-or-later
// Declares pinned refits on which Algorithm 1 as printed fails or is undefined, and the repaired one holds.
#pragma once

#include <string>
#include <vector>

#include "proptests/gen/refit_case.hpp"

namespace proptests::counterexamples {

struct PinnedRefit {
  std::string finding;  // what is wrong in print
  gen::RefitCase input;
  // These are the weights of a vertex at S's center, in the first joint-set.
  std::vector<gen::Rational> weights;
  // The printed algorithm divides by zero; otherwise its ball misses the vertex.
  bool undefined;
};

const std::vector<PinnedRefit>& algorithm1();

}  // namespace proptests::counterexamples
