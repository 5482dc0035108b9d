#include "proptests/verdict_table.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

#include "algorithms/results/result_file.hpp"

namespace proptests {
namespace {

// The verdict on the statement, not on the test: a statement that the tests refute is refuted.
std::string verdict_of_statement(const Outcome& o) {
  if (!o.passed) return "TEST FAILED";
  return o.kind == "refuted" ? "refuted" : "holds";
}

bool is_statement(const Outcome& o) {
  return o.kind != "example" && !o.options.form.empty() && o.options.hypothesis.empty();
}

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

// One line of the table, gathered from the outcomes of one stem.
struct Line {
  bool failed = false;
  long refuted_after = 0, printed_cases = 0, cases = 0;
  double degenerate = 0;
  std::set<std::string> number_types, hypotheses;

  void add(const Outcome& o) {
    failed = failed || !o.passed;
    if (!o.options.number_type.empty()) number_types.insert(o.options.number_type);
    if (!o.options.hypothesis.empty()) hypotheses.insert(o.options.hypothesis);
    if (!is_statement(o)) return;
    if (o.options.form == "printed") {
      if (o.kind == "refuted")
        refuted_after = refuted_after ? std::min(refuted_after, o.cases) : o.cases;
      else
        printed_cases += o.cases;
    } else if (o.kind == "holds") {
      cases += o.cases;
      degenerate += o.degenerate_share * static_cast<double>(o.cases);
    }
  }

  std::string printed() const {
    if (refuted_after) return "**refuted** after " + std::to_string(refuted_after);
    return printed_cases ? "holds (" + std::to_string(printed_cases) + ")" : "";
  }
  std::string repaired() const {
    if (cases == 0) return "";
    return "holds (" + std::to_string(cases) + ", " + percent(degenerate / static_cast<double>(cases)) + " degenerate)";
  }
};

std::string join(const std::set<std::string>& parts, const char* between) {
  std::string out;
  for (const auto& part : parts) out += (out.empty() ? "" : between) + part;
  return out;
}

// Markdown cells end at a bar.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::string opening = "<!-- verdicts -->\n", closing = "<!-- /verdicts -->";

// Where the table begins and ends in the text of a file.
std::pair<std::size_t, std::size_t> place_of_table(const std::string& file, const std::string& text) {
  const std::size_t from = text.find(opening), to = text.find(closing);
  if (from == std::string::npos || to == std::string::npos || to < from)
    throw std::runtime_error(file + ": the lines " + opening.substr(0, opening.size() - 1) + " and " + closing + " are missing");
  return {from + opening.size(), to};
}

}  // namespace

std::string verdict_table(const std::vector<Outcome>& outcomes) {
  std::map<std::string, Line> lines;
  std::set<std::string> with_statement;
  for (const Outcome& o : outcomes) {
    lines[o.stem].add(o);
    if (is_statement(o)) with_statement.insert(o.stem);
  }
  std::ostringstream out;
  out << "| statement | as printed | repaired, or beyond | numbers | hypotheses shown necessary |\n|---|---|---|---|---|\n";
  for (const auto& [stem, line] : lines)
    if (with_statement.count(stem))
      out << "| " << stem << " | " << (line.failed ? "TEST FAILED" : line.printed()) << " | "
          << (line.failed ? "TEST FAILED" : line.repaired()) << " | " << join(line.number_types, ", ") << " | "
          << cell(join(line.hypotheses, "; ")) << " |\n";
  return out.str();
}

void write_verdicts(const std::vector<Outcome>& outcomes, const std::string& folder) {
  refitlab::ResultFile file({"lemma", "form", "verdict", "cases", "degenerate_share", "number_type", "statement"});
  for (const Outcome& o : outcomes)
    if (is_statement(o))
      file.add({o.stem, o.options.form, verdict_of_statement(o), std::to_string(o.cases),
                refitlab::format_number(o.degenerate_share), o.options.number_type, o.sentence},
               o.seed);
  file.write(folder + "/verdicts.csv");
  refitlab::write_whole(folder + "/verdicts.md", verdict_table(outcomes));
}

std::string table_in(const std::string& file) {
  const std::string text = read(file);
  const auto [from, to] = place_of_table(file, text);
  return text.substr(from, to - from);
}

void put_table_in(const std::string& file, const std::string& table) {
  std::string text = read(file);
  const auto [from, to] = place_of_table(file, text);
  refitlab::write_whole(file, text.replace(from, to - from, table));
}

}  // namespace proptests
