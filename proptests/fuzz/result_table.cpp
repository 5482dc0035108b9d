// SPDX-License-Identifier: GPL-3.0-or-later
// The reader of result files: a table that fits its columns and is written as it was read, or a refusal.
#include "algorithms/results/result_table.hpp"

#include "algorithms/results/result_file.hpp"
#include "proptests/fuzz/target.hpp"

using namespace refitlab;

FUZZ_TARGET(result_table, bytes) try {
  const ResultTable table = parse_results(bytes, "fuzz.csv");
  ResultFile copy(table.columns);
  for (const auto& row : table.rows) copy.add(row);
  for (std::size_t r = 0; r < table.rows.size(); ++r) try {
      table.number(r, table.columns[0]);
    } catch (const ResultError&) {
    }
  for (const char* name : {"commit", "dirty", "compiler", "flags", "cpu", "seed"})
    for (const std::string& column : table.columns)
      if (column == name) return;  // the copy would have it twice
  const ResultTable again = parse_results(copy.text(), "copy.csv");
  check(again.rows.size() == table.rows.size(), "a table is read back with as many rows");
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    check(std::equal(table.rows[r].begin(), table.rows[r].end(), again.rows[r].begin()), "a row is read back as it was");
} catch (const ResultError& e) {
  check(std::string(e.what()).starts_with("fuzz.csv: line "), "a refusal names the file and the line");
}
