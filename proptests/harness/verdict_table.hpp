// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the verdicts of a run as a table. experiments/report sums them up by lemma, for the README, the report and the paper.
#pragma once

#include <string>
#include <vector>

#include "proptests/harness/harness.hpp"

namespace proptests {

// Writes verdicts.csv in the folder, which has a row for each outcome. The stem is that of the file of the lemma or algorithm, and
// the property is the sentence that is tested. The role is "statement" for what the lemma or algorithm says, "hypothesis" for a
// hypothesis without which it fails, and "other" for the rest, examples among them.
void write_verdicts(const std::vector<Outcome>& outcomes, const std::string& folder);

}  // namespace proptests
