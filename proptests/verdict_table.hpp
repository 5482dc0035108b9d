// The verdict table: what a run says of each lemma and algorithm, a line each.
#pragma once

#include <string>
#include <vector>

#include "proptests/harness.hpp"

namespace proptests {

// Markdown: lemma, printed form, repaired form (or the one beyond the paper), number types, hypotheses shown necessary.
std::string verdict_table(const std::vector<Outcome>& outcomes);

// verdicts.csv, a row a property, and verdicts.md, the table.
void write_verdicts(const std::vector<Outcome>& outcomes, const std::string& folder);

// The table that stands in a file between the lines <!-- verdicts --> and <!-- /verdicts -->, without them. Throws
// std::runtime_error that names the file if it is not there.
std::string table_in(const std::string& file);

// Puts a table there in its place.
void put_table_in(const std::string& file, const std::string& table);

}  // namespace proptests
