// SPDX-License-Identifier: GPL-3.0-or-later
// Two tests look at one part of a hypothesis (one sign, one element of a list, one side of an inequality). Without it another
// theorem would be stated, and a false one.
#pragma once

#include <string>

#include "lemmas/vocabulary/verdict.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests {

// Says what a case that violates one part of a hypothesis, and no other, makes of the theorem.
struct Violation {
  refitlab::Verdict hypothesis, conclusion;
};

// Tests that the hypothesis refuses all of the Violations of that part that draw() makes, and that the conclusion fails for some.
// The tag says for what share of the cases.
template <class Draw>
void needs_part(Suite& t, const std::string& part, const Draw& draw, int cases = 200) {
  using refitlab::Verdict;
  t.holds("the hypothesis refuses what violates this part of it alone: " + part, {.number_type = "rational", .cases = cases},
          [draw] {
            const Violation v = draw();
            RC_CLASSIFY(v.conclusion != Verdict::holds, "the conclusion fails");
            RC_ASSERT(v.hypothesis == Verdict::fails);
          });
  t.refuted("the conclusion holds without this part of the hypothesis: " + part, {.number_type = "rational", .cases = cases},
            [draw] { RC_ASSERT(draw().conclusion == Verdict::holds); });
}

// Tests the same of a theorem of R^d: draw(d) makes the Violation in one of R^low ... R^high, which is drawn for each case.
template <int low, int high, class Draw>
void needs_part_in(Suite& t, const std::string& part, const Draw& draw, int cases = 200) {
  const auto in_some_dimension = [draw] {
    Violation v{refitlab::Verdict::holds, refitlab::Verdict::holds};  // neither claim lets these pass
    gen::for_some_dimension<low, high>([&](auto d) { v = draw(d); });
    return v;
  };
  needs_part(t, part, in_some_dimension, cases);
}

}  // namespace proptests
