// SPDX-License-Identifier: GPL-3.0-or-later
// Result files read back: what was written, or a refusal with file, line and reason.
#include "algorithms/results/result_table.hpp"

#include <cmath>
#include <cstring>
#include <set>

#include "algorithms/results/result_file.hpp"
#include "proptests/gen/temporary_folder.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_result_table {
namespace {

using namespace refitlab;
using Rows = std::vector<std::vector<std::string>>;

// Text in which every character that CSV gives a meaning is likely.
std::string draw_text() {
  return *rc::gen::container<std::string>(rc::gen::weightedOneOf<char>(
      {{3, rc::gen::element(',', '"', '\n', '\r')}, {2, rc::gen::inRange('a', 'z')}, {1, rc::gen::arbitrary<char>()}}));
}

struct Written {
  std::vector<std::string> columns;
  Rows rows;
  std::string text;
};

Written draw_file() {
  std::set<std::string> names;
  const int width = *rc::gen::inRange(1, 5), height = *rc::gen::inRange(0, 5);
  while (static_cast<int>(names.size()) < width) names.insert("c" + std::to_string(names.size()) + draw_text());
  Written out{{names.begin(), names.end()}, {}, {}};
  ResultFile file(out.columns);
  for (int r = 0; r < height; ++r) {
    out.rows.emplace_back();
    for (int c = 0; c < width; ++c) out.rows.back().push_back(draw_text());
    file.add(out.rows.back(), static_cast<std::uint64_t>(r));
  }
  out.text = file.text();
  return out;
}

bool is_a_start_of(const Rows& some, const Rows& all) {
  return some.size() <= all.size() && std::equal(some.begin(), some.end(), all.begin());
}

bool same_double(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

std::string refusal(const std::string& text) {
  try {
    parse_results(text, "bad.csv");
  } catch (const ResultError& e) {
    return e.what();
  }
  return "";
}

Checked refusals() {
  const struct {
    std::string text, message;
  } list[] = {
      {"", "line 1: is empty: it has no columns"},
      {"a,b", "line 1: ends early: the last line has no end"},
      {"a,b\n1,\"2\"", "line 2: ends early: the last line has no end"},
      {"a,,b\n", "line 1: a column has no name"},
      {"\n", "line 1: a column has no name"},
      {"a,b,a\n", "line 1: two columns are named 'a'"},
      {"a,b\n1,2\n1\n", "line 3: 1 values for 2 columns"},
      {"a,b\n1,2,3\n", "line 2: 3 values for 2 columns"},
      {"a,b\n\n", "line 2: 1 values for 2 columns"},
      {"a,b\n1,2\"\n", "line 2: a quote inside a field that does not start with one"},
      {"a,b\n\"1\n\n\",2\n1,\"2\"x\n", "line 5: text after a closing quote"},
      {"a,b\n1,2\n1,\"2\n3,4\n", "line 3: a quote is never closed"},
      {"a,b\n1,2\r3\n", "line 2: a carriage return alone"},
      {"a,b\n1,2\r", "line 2: a carriage return alone"},
  };
  std::string wrong;
  for (const auto& [text, message] : list)
    if (refusal(text) != "bad.csv: " + message) wrong += "'" + text + "': " + refusal(text) + "; ";
  return {wrong.empty(), std::size(list), wrong};
}

}  // namespace

PROPTEST(result_table) {
  t.holds("what was written is read back, with a line for each row", {.cases = 1000, .degenerate_at_least = 0.05}, [] {
    const Written file = draw_file();
    RC_CLASSIFY(file.rows.empty(), "degenerate");
    const ResultTable table = parse_results(file.text, "file.csv");
    auto columns = file.columns;
    columns.insert(columns.end(), {"commit", "dirty", "compiler", "flags", "cpu", "seed"});
    RC_ASSERT(table.columns == columns);
    RC_ASSERT(table.rows.size() == file.rows.size() && table.lines.size() == file.rows.size());
    for (std::size_t r = 0; r < file.rows.size(); ++r) {
      RC_ASSERT(std::equal(file.rows[r].begin(), file.rows[r].end(), table.rows[r].begin()));
      RC_ASSERT(table.value(r, "compiler") == Provenance::of_this_build().compiler);
      RC_ASSERT(table.number(r, "seed") == static_cast<double>(r));
      const auto& before = r ? table.rows[r - 1] : table.columns;
      long ends = 1;
      for (const auto& field : before) ends += std::count(field.begin(), field.end(), '\n');
      RC_ASSERT(static_cast<long>(table.lines[r]) == (r ? static_cast<long>(table.lines[r - 1]) : 1) + ends);
    }
  });
  t.holds("a file that is cut is refused or has its first rows", {.cases = 1000}, [] {
    const Written file = draw_file();
    const Rows all = parse_results(file.text, "file.csv").rows;
    const std::string cut = file.text.substr(0, *rc::gen::inRange<std::size_t>(0, file.text.size()));
    try {
      const ResultTable table = parse_results(cut, "file.csv");
      RC_ASSERT(cut.ends_with('\n') && table.rows.size() < all.size() && is_a_start_of(table.rows, all));
    } catch (const ResultError& e) {
      RC_ASSERT(std::string(e.what()).starts_with("file.csv: line "));
    }
  });
  t.holds("whatever the text, it is read as a table that fits its columns, or refused", {.cases = 2000}, [] {
    const std::string text = draw_text();
    try {
      const ResultTable table = parse_results(text, "file.csv");
      for (const auto& row : table.rows) RC_ASSERT(row.size() == table.columns.size());
      RC_ASSERT(!table.columns.empty());
    } catch (const ResultError&) {
    }
  });
  t.holds("a number is read back as the same double, and text around it is refused", {.cases = 2000}, [] {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double drawn = 0;
    std::memcpy(&drawn, &bits, sizeof drawn);
    const double number = *rc::gen::element(drawn, 0.0, -0.0, INFINITY, -INFINITY, NAN, 5e-324, *rc::gen::arbitrary<double>());
    const std::string text = format_number(number);
    const auto read = [](const std::string& value) { return parse_results("x\n\"" + value + "\"\n", "file.csv").number(0, "x"); };
    RC_ASSERT(same_double(read(text), number));
    for (const std::string& bad : {" " + text, text + " ", text + "x", std::string()}) {
      bool refused = false;
      try {
        read(bad);
      } catch (const ResultError& e) {
        refused = e.what() == "file.csv: line 2: 'x' is no number: '" + bad + "'";
      }
      RC_ASSERT(refused);
    }
  });
  t.example("lines may end with CRLF", {}, [] {
    const ResultTable table = parse_results("a,b\r\n1,\"2\r\n\"\r\n", "file.csv");
    return Checked(table.rows == Rows{{"1", "2\r\n"}} && table.columns == std::vector<std::string>{"a", "b"});
  });
  t.example("bad text is refused with the file, the line and the reason", {}, refusals);
  t.example("a file is read as its text; one that is missing, and a column that is not there, are refused", {}, [] {
    const gen::TemporaryFolder folder;
    ResultFile file({"a"});
    file.add({"1,5"});
    file.write(folder.file("results.csv"));
    const ResultTable table = read_results(folder.file("results.csv"));
    std::string no_file, no_column;
    try {
      read_results(folder.file("missing.csv"));
    } catch (const std::runtime_error& e) {
      no_file = e.what();
    }
    try {
      table.column("b");
    } catch (const ResultError& e) {
      no_column = e.what();
    }
    return Checked(table.value(0, "a") == "1,5" &&
                       no_file == folder.file("missing.csv") + ": cannot read: No such file or directory" &&
                       no_column == folder.file("results.csv") + ": line 1: there is no column 'b'",
                   3, no_file + "; " + no_column);
  });
  t.example("a row of too few values or too many is refused when it is added", {}, [] {
    ResultFile file({"a", "b"});
    long refused = 0;
    for (const std::vector<std::string>& row : {std::vector<std::string>{"1"}, {"1", "2", "3"}, {}}) {
      try {
        file.add(row);
      } catch (const std::logic_error& e) {
        refused += std::string(e.what()) == "a result row must have a value per column";
      }
    }
    return Checked(refused == 3, 3);
  });
}

}  // namespace proptests::suite_result_table
