#include "proptests/verdict_table.hpp"

#include <cstdio>
#include <sstream>

#include "algorithms/results/result_file.hpp"

namespace proptests {
namespace {

// The verdict on the statement, not on the test: a statement that the tests refute is refuted.
std::string verdict_of_statement(const Outcome& o) {
  if (!o.passed) return "TEST FAILED";
  return o.kind == "refuted" ? "refuted" : "holds";
}

bool is_statement(const Outcome& o) { return !o.options.form.empty() && o.options.hypothesis.empty(); }

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

}  // namespace

std::string verdict_table(const std::vector<Outcome>& outcomes) {
  std::ostringstream out;
  out << "| lemma | form | statement | verdict | cases | degenerate | numbers |\n|---|---|---|---|---|---|---|\n";
  for (const Outcome& o : outcomes)
    if (is_statement(o) && o.kind != "example")
      out << "| " << o.stem << " | " << o.options.form << " | " << o.sentence << " | " << verdict_of_statement(o) << " | "
          << (o.kind == "refuted" ? "after " : "") << o.cases << " | " << percent(o.degenerate_share) << " | "
          << o.options.number_type << " |\n";
  return out.str();
}

void write_verdicts(const std::vector<Outcome>& outcomes, const std::string& folder) {
  refitlab::ResultFile file({"lemma", "form", "verdict", "cases", "degenerate_share", "number_type", "statement"});
  for (const Outcome& o : outcomes)
    if (is_statement(o) && o.kind != "example")
      file.add({o.stem, o.options.form, verdict_of_statement(o), std::to_string(o.cases),
                refitlab::format_number(o.degenerate_share), o.options.number_type, o.sentence},
               o.seed);
  file.write(folder + "/verdicts.csv");
  refitlab::write_whole(folder + "/verdicts.md", verdict_table(outcomes));
}

}  // namespace proptests
