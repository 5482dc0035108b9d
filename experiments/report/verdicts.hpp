// The verdict table of the lemmas, read from what proptests/run wrote.
#pragma once

#include <string>
#include <vector>

#include "algorithms/results/result_table.hpp"

namespace refitlab {

// Of one statement, over its properties.
struct LemmaVerdict {
  std::string lemma;                  // the stem of its file
  bool failed = false;                // a test failed: nothing is said
  long refuted_after = 0;             // cases until the first counterexample to what is printed; 0: none was found
  long printed_cases = 0, cases = 0;  // in which what is printed, or repaired, held
  double degenerate = 0;              // of the latter
  std::vector<std::string> number_types;
};

// By lemma, in the table's order. Throws ResultError for columns or numbers that are not there.
std::vector<LemmaVerdict> verdicts_of(const ResultTable& table);

// The section of the report. path: of verdicts.csv, whose absence, another commit than the given one, or errors are
// said in the page. page_folder: where the page will be; reference: from there, the folder of the teaching reference,
// whose pages are linked, or empty.
std::string verdicts_section(const std::string& path, const std::string& commit, const std::string& page_folder,
                             const std::string& reference);

}  // namespace refitlab
