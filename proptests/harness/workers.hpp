// SPDX-License-Identifier: GPL-3.0-or-later
// Runs suites in several processes at a time. Threads would not do: suites change the floating-point environment and kill what
// they started.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "proptests/harness/harness.hpp"

namespace proptests {

// Holds what is known of a suite that has run.
struct SuiteResult {
  std::vector<Outcome> outcomes;
  // These are those of all errors thrown in it, caught or not.
  std::set<std::string> messages;
};

// Runs suites in at least one worker process. run runs the suite with this stem in its process, which may have run others. What a
// suite prints is shown when it has ended, after its number in the order in which they end. Returns a result for each stem, in
// their order. Throws std::runtime_error if a process ends before its time, with the suites that then have no result.
std::vector<SuiteResult> run_in_processes(const std::vector<std::string>& stems, int workers,
                                          const std::function<SuiteResult(const std::string&)>& run);

}  // namespace proptests
