// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the list of errors, errors.md: each with where it is thrown, and the suite that provokes it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace proptests {

struct ListedError {
  std::string message;  // "..." stands for anything
  std::string file;     // This file throws it.
  // It is thrown in this suite; or this is "none: " and why it cannot be.
  std::string suite;
};

// Reads the list. Throws std::runtime_error for a line that is no row.
std::vector<ListedError> read_error_list(const std::string& file);

// Returns what throws errors and is not on the list: places of the sources, from the root of the repository.
std::vector<std::string> unlisted_errors(const std::vector<ListedError>& list);

// Returns the errors of the list that none of these messages is, of suites that have run.
std::vector<std::string> unseen_errors(const std::vector<ListedError>& list, const std::set<std::string>& suites,
                                       const std::map<std::string, std::set<std::string>>& messages);

// Says whether a message is one of those that a pattern with "..." stands for.
bool is_like(const std::string& message, const std::string& pattern);

}  // namespace proptests
