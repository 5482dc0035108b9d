// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the reader of case files: it returns cases whose fields can be read, or refuses.
#include "proptests/cases/case_file.hpp"

#include "proptests/fuzz/target.hpp"

using namespace proptests::cases;

FUZZ_TARGET(case_file, bytes) try {
  const std::vector<Case> cases = parse_cases(bytes, "fuzz.json", [](const Case&) {});
  as_markdown(cases);
  for (const Case& c : cases) try {
      // It is read whatever the case is about.
      read_refit(c.fields());
    } catch (const CaseError& e) {
      check(std::string(e.what()).find("case '" + c.name + "'") != std::string::npos, "a refusal names the case");
    }
} catch (const CaseError& e) {
  check(std::string(e.what()).starts_with("fuzz.json"), "a refusal names the file");
}
