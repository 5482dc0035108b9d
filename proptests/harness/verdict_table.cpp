// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/harness/verdict_table.hpp"

#include "algorithms/results/result_file.hpp"

namespace proptests {
namespace {

// Returns the verdict on the statement, not on the test: a statement that the tests refute is refuted.
std::string verdict_of_statement(const Outcome& o) {
  if (o.skipped) return "skipped";
  if (!o.passed) return "TEST FAILED";
  return o.kind == "refuted" ? "refuted" : "holds";
}

std::string role_of(const Outcome& o) {
  if (!o.options.hypothesis.empty()) return "hypothesis";
  return o.kind != "example" && !o.options.form.empty() ? "statement" : "other";
}

}  // namespace

void write_verdicts(const std::vector<Outcome>& outcomes, const std::string& folder) {
  refitlab::ResultFile file(
      {"stem", "role", "form", "verdict", "cases", "share_of_degenerate_cases", "number_type", "hypothesis", "property"});
  for (const Outcome& o : outcomes)
    file.add({o.stem, role_of(o), o.options.form, verdict_of_statement(o), std::to_string(o.cases),
              refitlab::format_number(o.degenerate_share), o.options.number_type, o.options.hypothesis, o.sentence},
             o.seed);
  file.write(folder + "/verdicts.csv");
}

}  // namespace proptests
