// The verdict table: what the run says of each lemma, as text for people and as a result file.
#pragma once

#include <string>
#include <vector>

#include "proptests/harness.hpp"

namespace proptests {

std::string verdict_table(const std::vector<Outcome>& outcomes);  // Markdown
void write_verdicts(const std::vector<Outcome>& outcomes, const std::string& folder);

}  // namespace proptests
