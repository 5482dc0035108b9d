// SPDX-License-Identifier: GPL-3.0-or-later
// Decides one statement by every number type on the same case: no interval may contradict the exact verdict.
#pragma once

#include <rapidcheck.h>

#include "lemmas/exact/ladder.hpp"

namespace proptests {

// Returns the exact verdict. Asserts that the ladder's intervals answer the same or nothing, and tags the case with the lowest
// rung that decides, and with "double is wrong" where plain doubles answer otherwise.
template <class Exact = refitlab::Rational, class Statement, class... Inputs>
refitlab::Verdict decide_by_all(const Statement& statement, const Inputs&... inputs) {
  using namespace refitlab;
  const Verdict exact = statement(lift<Exact>(inputs)...);
  RC_ASSERT(exact != Verdict::undecided);
  const Verdict quick = statement(lift<Interval>(inputs)...);
  const Verdict closer = statement(lift<MultiprecisionInterval>(inputs)...);
  RC_ASSERT(quick == exact || quick == Verdict::undecided);
  RC_ASSERT(closer == exact || closer == Verdict::undecided);
  const Decision decision = decide<Exact>(statement, inputs...);
  RC_ASSERT(decision.verdict == exact);
  RC_TAG(std::string("decided by ") + name_of(decision.rung));
  RC_CLASSIFY(statement(lift<double>(inputs)...) != exact, "double is wrong");
  return exact;
}

}  // namespace proptests
