// SPDX-License-Identifier: GPL-3.0-or-later
// Declares the inputs of cases that are pinned in proptests/counterexamples. There they are written by hand; cases.json has them
// from there (proptests --write-cases), for readers of other languages.
#pragma once

#include "proptests/cases/case_file.hpp"

namespace proptests::cases {

struct PinnedInputs {
  std::string name;  // of the case
  Json fields;       // those of its inputs that are pinned
};

std::vector<PinnedInputs> pinned_inputs();

// Returns the text of a file of cases with the inputs that are pinned in place of its own. Throws CaseError if a case is not
// there.
std::string with_pinned_inputs(const std::string& text);

}  // namespace proptests::cases
