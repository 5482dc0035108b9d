#include "experiments/report/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "experiments/report/html.hpp"

namespace refitlab {
namespace {

void add_row(LemmaVerdict& v, const ResultTable& table, std::size_t row) {
  const std::string &form = table.value(row, "form"), &verdict = table.value(row, "verdict"),
                    &number_type = table.value(row, "number_type");
  const long cases = std::lround(table.number(row, "cases"));
  if (!number_type.empty() &&
      std::find(v.number_types.begin(), v.number_types.end(), number_type) == v.number_types.end())
    v.number_types.push_back(number_type);
  if (verdict != "holds" && verdict != "refuted") v.failed = true;
  if (form == "printed" && verdict == "refuted")
    v.refuted_after = v.refuted_after ? std::min(v.refuted_after, cases) : cases;
  if (form == "printed" && verdict == "holds") v.printed_cases += cases;
  if (form != "printed" && verdict == "holds") {
    v.cases += cases;
    v.degenerate += table.number(row, "degenerate_share") * static_cast<double>(cases);
  }
}

void write_row(std::ostringstream& out, const LemmaVerdict& v, const std::string& reference) {
  const std::string name = escape_html(v.lemma);
  out << "<tr><td>" << (reference.empty() ? name : "<a href=\"" + reference + "/" + name + ".html\">" + name + "</a>")
      << "</td><td>";
  if (v.failed) out << "<span class=\"bad\">TEST FAILED</span>";
  else if (v.refuted_after) out << "<span class=\"bad\">refuted</span> after " << v.refuted_after;
  else if (v.printed_cases) out << "holds (" << v.printed_cases << ")";
  out << "</td><td>";
  if (!v.failed && v.cases)
    out << "holds (" << v.cases << format(", %.0f %% degenerate)", 100 * v.degenerate / static_cast<double>(v.cases));
  out << "</td><td>";
  for (std::size_t i = 0; i < v.number_types.size(); ++i) out << (i ? ", " : "") << escape_html(v.number_types[i]);
  out << "</td></tr>\n";
}

std::string commits_of(const ResultTable& table) {
  std::set<std::string> commits;
  for (std::size_t row = 0; row < table.rows.size(); ++row) commits.insert(table.value(row, "commit"));
  std::string out;
  for (const auto& commit : commits) out += (out.empty() ? "" : ", ") + commit;
  return out;
}

}  // namespace

std::vector<LemmaVerdict> verdicts_of(const ResultTable& table) {
  std::vector<LemmaVerdict> out;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& lemma = table.value(row, "lemma");
    auto at = std::find_if(out.begin(), out.end(), [&](const LemmaVerdict& v) { return v.lemma == lemma; });
    if (at == out.end()) at = out.insert(at, LemmaVerdict{lemma});
    add_row(*at, table, row);
  }
  return out;
}

std::string verdicts_section(const std::string& path, const std::string& commit, const std::string& page_folder,
                             const std::string& reference) {
  std::ostringstream out;
  out << "<h2>Verdicts on the lemmas</h2>\n";
  if (!std::filesystem::exists(path)) {
    out << "<p>None yet: <code>proptests/run</code> checks every statement and writes them to "
           "<code>out/results/verdicts.csv</code>; "
           "the next <code>experiments/run</code> shows them here.</p>\n";
    return out.str();
  }
  try {
    const ResultTable table = read_results(path);
    const auto verdicts = verdicts_of(table);
    const std::string commits = commits_of(table);
    out << "<p>What <code>proptests/run</code> says of each statement: refuted after so many random cases, or holding "
           "in all of them "
           "(in brackets, with the share of degenerate ones).";
    if (commits != commit)
      out << " <span class=\"bad\">They are of another commit than this page: " << escape_html(commits) << ".</span>";
    out << "</p><div class=\"scroll\"><table class=\"verdict-table\"><thead><tr><th>statement</th><th>as "
           "printed</th><th>repaired, or "
           "beyond</th><th>numbers</th></tr></thead><tbody>\n";
    for (const LemmaVerdict& v : verdicts) {
      const bool has_page =
          !reference.empty() && std::filesystem::exists(page_folder + "/" + reference + "/" + v.lemma + ".html");
      write_row(out, v, has_page ? reference : "");
    }
    out << "</tbody></table></div>\n";
  } catch (const std::exception& e) {  // a page without verdicts is better than none after a long run
    out << "<p class=\"bad\">" << escape_html(e.what()) << "</p>\n";
  }
  return out.str();
}

}  // namespace refitlab
