// SPDX-License-Identifier: GPL-3.0-or-later
// Records every error that was thrown, caught or not, while the suites ran. This shows that a test provokes it.
#pragma once

#include <map>
#include <set>
#include <string>

namespace proptests {

// Records errors from now on as thrown by this suite.
void record_errors_of(const std::string& stem);

// Returns the messages of all std::exceptions, by suite.
std::map<std::string, std::set<std::string>> recorded_errors();

}  // namespace proptests
