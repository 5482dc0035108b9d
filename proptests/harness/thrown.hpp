// SPDX-License-Identifier: GPL-3.0-or-later
// Every error that was thrown, caught or not, while the suites ran: what shows that a test provokes it.
#pragma once

#include <map>
#include <set>
#include <string>

namespace proptests {

// From now on errors are thrown by this suite.
void record_errors_of(const std::string& stem);

// The messages of all std::exceptions, by suite.
std::map<std::string, std::set<std::string>> recorded_errors();

}  // namespace proptests
